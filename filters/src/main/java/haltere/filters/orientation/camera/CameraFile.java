package haltere.filters.orientation.camera;

import haltere.core.format.RecordingFile;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Calibrated cameras from a file, by content: JSON
 *
 * <pre>{@code
 * {"cameras": [{"id": "left", "matrix": [[4 numbers], [4], [4]],
 *               "distortion": [k1, k2, p1, p2, k3], "width": 640, "height": 480}]}
 * }</pre>
 *
 * <p>in which distortion, width and height may be absent; or the XML of a {@code
 * multi_camera_reconstructor} ({@link CameraXml}).
 *
 * @param cameras the cameras, in the order of the file
 * @param minEccentricity smallest ratio of the axes in the calibration, 0 for any
 */
public record CameraFile(List<CameraModel> cameras, double minEccentricity) {
  public CameraFile {
    cameras = List.copyOf(cameras);
  }

  /**
   * Reads a file.
   *
   * @param file JSON or XML
   * @return at least one camera; invalid ones have a {@linkplain CameraModel#problem problem}
   * @throws JsonProblem if it is neither, or has no cameras; the message names the file
   * @throws IOException if it cannot be read
   */
  public static CameraFile read(Path file) throws IOException {
    RecordingFile.checkRegular(file);
    byte[] bytes = Files.readAllBytes(file);
    if (looksLikeXml(bytes)) {
      try (InputStream in = new java.io.ByteArrayInputStream(bytes)) {
        return CameraXml.read(in, file.toString());
      }
    }
    Object value = Json.read(file);
    if (!(value instanceof Map<?, ?> object) || !(object.get("cameras") instanceof List<?> list)) {
      throw new JsonProblem(
          file + ": cameras are a JSON object with the key \"cameras\" and a list, or XML");
    }
    List<CameraModel> cameras = new ArrayList<>();
    for (Object each : list) {
      cameras.add(camera(each, file + ": camera " + (cameras.size() + 1)));
    }
    return checked(cameras, file.toString(), 0);
  }

  static CameraFile checked(List<CameraModel> cameras, String name, double minEccentricity)
      throws JsonProblem {
    if (cameras.isEmpty()) {
      throw new JsonProblem(name + ": there is no camera in it");
    }
    Set<String> ids = new HashSet<>();
    for (CameraModel camera : cameras) {
      if (!ids.add(camera.id())) {
        throw new JsonProblem(name + ": two cameras have the id " + camera.id());
      }
    }
    return new CameraFile(cameras, minEccentricity);
  }

  private static boolean looksLikeXml(byte[] bytes) {
    String head =
        new String(bytes, 0, Math.min(bytes.length, 256), StandardCharsets.UTF_8)
            .replace("\ufeff", "")
            .strip();
    return head.startsWith("<");
  }

  private static CameraModel camera(Object value, String name) throws JsonProblem {
    if (!(value instanceof Map<?, ?> object)) {
      throw new JsonProblem(name + " is not an object with \"id\" and \"matrix\"");
    }
    Object id = object.get("id");
    if (!(id instanceof String || id instanceof Long)) {
      throw new JsonProblem(name + " has no \"id\"");
    }
    if (!(object.get("matrix") instanceof List<?> rows) || rows.size() != 3) {
      throw new JsonProblem(name + ": \"matrix\" must be a list of 3 lists of 4 numbers");
    }
    double[] matrix = new double[12];
    for (int i = 0; i < 3; i++) {
      double[] row = numbers(rows.get(i), name + ": row " + (i + 1) + " of \"matrix\"", 4);
      System.arraycopy(row, 0, matrix, 4 * i, 4);
    }
    Object distortion = object.get("distortion");
    double[] five =
        distortion == null
            ? new double[0]
            : numbers(distortion, name + ": \"distortion\" (k1, k2, p1, p2, k3)", 5);
    return CameraModel.of(
        id.toString(), matrix, five, size(object, "width", name), size(object, "height", name));
  }

  private static int size(Map<?, ?> object, String key, String name) throws JsonProblem {
    Object value = object.get(key);
    if (value == null) {
      return 0;
    }
    if (value instanceof Number number && number.doubleValue() >= 0 && number.doubleValue() < 1e6) {
      return number.intValue();
    }
    throw new JsonProblem(name + ": \"" + key + "\" must be a number of pixels, not " + value);
  }

  private static double[] numbers(Object value, String name, int count) throws JsonProblem {
    if (value instanceof List<?> list
        && list.size() == count
        && list.stream().allMatch(Number.class::isInstance)) {
      return list.stream().mapToDouble(each -> ((Number) each).doubleValue()).toArray();
    }
    throw new JsonProblem(name + " must be a list of " + count + " numbers, not " + value);
  }
}
