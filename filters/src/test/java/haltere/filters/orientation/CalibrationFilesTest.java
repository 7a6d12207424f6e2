package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import haltere.core.simulation.internal.flight.FlightDetection;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.filters.orientation.camera.CameraFile;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.ObservationFile;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.TreeMap;
import java.util.zip.GZIPOutputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CalibrationFilesTest {
  @TempDir Path folder;

  private Path file(String text) throws IOException {
    return Files.writeString(folder.resolve("cameras"), text);
  }

  private void assertRefused(String text, String... words) throws IOException {
    Path file = file(text);
    IOException problem = assertThrows(IOException.class, () -> CameraFile.read(file));
    assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
    for (String word : words) {
      assertTrue(problem.getMessage().contains(word), problem.getMessage());
    }
  }

  @Test
  void camerasAreReadFromJson() throws IOException {
    CameraFile read =
        CameraFile.read(
            file(
                """
                {"cameras": [
                  {"id": "a", "matrix": [[800, 0, 320, 10], [0, 820, 240, 20], [0, 0, 1, 2]],
                   "distortion": [-0.3, 0.1, 0.001, 0, 0], "width": 640, "height": 480},
                  {"id": "b", "matrix": [[800, 0, 320, 10], [0, 820, 240, 20], [0, 0, 1, 3]]}]}
                """));
    assertEquals(2, read.cameras().size());
    CameraModel a = read.cameras().get(0);
    assertEquals("a", a.id());
    assertEquals(640, a.widthPx());
    double[] ideal = new double[2];
    double[] seen = new double[2];
    double[] point = {0.5, 0.4, 1};
    a.projectIdeal(point, ideal);
    a.project(point, seen);
    assertEquals((800 * 0.5 + 320 + 10) / 3, ideal[0], 1e-9);
    // r is measured from the principal point in units of the focal lengths of the matrix.
    double x = (ideal[0] - 320) / 800;
    double y = (ideal[1] - 240) / 820;
    double r2 = x * x + y * y;
    double radial = 1 - 0.3 * r2 + 0.1 * r2 * r2;
    assertEquals(320 + 800 * (x * radial + 0.002 * x * y), seen[0], 1e-9);
    read.cameras().get(1).project(point, seen);
    assertEquals((800 * 0.5 + 330) / 4, seen[0], 1e-9);
  }

  @Test
  void errorsInJsonNameTheCamera() throws IOException {
    assertRefused("{}", "\"cameras\"");
    assertRefused("{\"cameras\": []}", "no camera");
    assertRefused("{\"cameras\": [{\"matrix\": []}]}", "camera 1", "id");
    assertRefused("{\"cameras\": [{\"id\": \"a\", \"matrix\": [[1, 2, 3, 4]]}]}", "camera 1", "3");
    assertRefused(
        "{\"cameras\": [{\"id\": \"a\", \"matrix\": [[1,2,3,4],[1,2,3],[1,2,3,4]]}]}",
        "camera 1",
        "row 2");
    String good = "{\"id\": \"a\", \"matrix\": [[8,0,3,1],[0,8,2,2],[0,0,1,2]]";
    assertRefused("{\"cameras\": [" + good + ", \"distortion\": [1, 2]}]}", "distortion");
    assertRefused("{\"cameras\": [" + good + ", \"width\": -3}]}", "width");
    assertRefused("{\"cameras\": [" + good + "}," + good + "}]}", "two cameras", "a");
    assertRefused("{\"cameras\": [", "cameras");
  }

  private static String xml(List<CameraModel> cameras) {
    StringBuilder xml = new StringBuilder("<multi_camera_reconstructor>\n");
    for (CameraModel camera : cameras) {
      double[] m = camera.matrix();
      StringBuilder rows = new StringBuilder();
      for (int i = 0; i < 12; i++) {
        rows.append(i > 0 && i % 4 == 0 ? "; " : " ").append(m[i]);
      }
      xml.append("<single_camera_calibration><cam_id>")
          .append(camera.id())
          .append("</cam_id><calibration_matrix>")
          .append(rows)
          .append("</calibration_matrix><resolution>640 480</resolution>")
          .append("<non_linear_parameters><fc1>700</fc1><fc2>710</fc2><cc1>320</cc1><cc2>240</cc2>")
          .append("<k1>0</k1><k2>0</k2><p1>0</p1><p2>0</p2><alpha_c>0</alpha_c>")
          .append("<fc1p>700</fc1p><fc2p>710</fc2p><cc1p>320</cc1p><cc2p>240</cc2p>")
          .append("</non_linear_parameters></single_camera_calibration>\n");
    }
    return xml + "<minimum_eccentricity>1.4</minimum_eccentricity></multi_camera_reconstructor>\n";
  }

  @Test
  void camerasAreReadFromXmlWithTheirLenses() throws IOException {
    List<CameraModel> cameras = Flights.cameras(Flights.scene(3, 1));
    CameraFile read = CameraFile.read(file(xml(cameras)));
    assertEquals(1.4, read.minEccentricity());
    assertEquals(3, read.cameras().size());
    double[] expected = new double[2];
    double[] seen = new double[2];
    for (int i = 0; i < 3; i++) {
      cameras.get(i).project(new double[] {0.05, 0.02, 0.01}, expected);
      read.cameras().get(i).project(new double[] {0.05, 0.02, 0.01}, seen);
      assertEquals(expected[0], seen[0], 1e-9);
      assertEquals(expected[1], seen[1], 1e-9);
    }
    String bent = xml(cameras).replaceFirst("<k1>0</k1>", "<k1>-0.3</k1>");
    CameraModel lens = CameraFile.read(file(bent)).cameras().get(0);
    lens.projectIdeal(new double[] {0.05, 0.02, 0.01}, expected);
    lens.project(new double[] {0.05, 0.02, 0.01}, seen);
    double x = (expected[0] - 320) / 700;
    double y = (expected[1] - 240) / 710;
    assertEquals(320 + 700 * x * (1 - 0.3 * (x * x + y * y)), seen[0], 1e-9);
  }

  @Test
  void errorsInXmlAreReported() throws IOException {
    String good = xml(Flights.cameras(Flights.scene(2, 1)));
    assertRefused(good.substring(0, 400), "line");
    assertRefused(good.replace(";", " "), "calibration_matrix");
    assertRefused(good.replace("<cc1p>320", "<cc1p>330"), "cc1p");
    assertRefused(good.replace("<k1>0", "<k1>much"), "k1", "number");
    assertRefused("<nothing/>", "no camera");
  }

  private static byte[] packed(String text) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(bytes)) {
      out.write(text.getBytes(StandardCharsets.UTF_8));
    }
    return bytes.toByteArray();
  }

  private Path braidz(FlightScene scene, int pictures, String without) throws IOException {
    StringBuilder info = new StringBuilder("camn,cam_id\n");
    StringBuilder points =
        new StringBuilder(
            "camn,frame,timestamp,cam_received_timestamp,device_timestamp,block_id,x,y,area,slope,"
                + "eccentricity,frame_pt_idx,cur_val,mean_val,sumsqf_val\n");
    StringBuilder whose = new StringBuilder("obj_id,frame,cam_num,pt_idx\n");
    for (int i = 0; i < scene.cameras().size(); i++) {
      info.append(i + 7).append(',').append(scene.cameras().get(i).id().replace('-', '_'));
      info.append('\n');
    }
    for (int camera = 0; camera < scene.cameras().size(); camera++) {
      for (int k = 0; k < pictures; k++) {
        for (FlightDetection each : scene.detections(k)) {
          if (each.camera().equals(scene.cameras().get(camera).id())) {
            String time = k % 3 == 0 ? "" : String.valueOf(each.tUs() * 1e-6);
            // A second point of the picture that belongs to nothing, and then the body.
            points.append(
                String.format(
                    Locale.ROOT,
                    "%d,%d,%s,%f,,,1.0,2.0,3.0,0.5,2.0,0,0,0.0,0.0%n",
                    camera + 7,
                    k,
                    time,
                    each.tUs() * 1e-6));
            points.append(
                String.format(
                    Locale.ROOT,
                    "%d,%d,%s,%f,,,%f,%f,%f,%s,%f,1,0,0.0,0.0%n",
                    camera + 7,
                    k,
                    time,
                    each.tUs() * 1e-6,
                    each.xPx(),
                    each.yPx(),
                    each.areaPx(),
                    Math.tan(each.angleRad()),
                    each.eccentricity()));
            whose.append(String.format(Locale.ROOT, "42,%d,%d,1%n", k, camera + 7));
          }
        }
      }
    }
    Path file = folder.resolve("flight.braidz");
    try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(file))) {
      add(zip, without, "README.md", "a test".getBytes(StandardCharsets.UTF_8));
      add(
          zip,
          without,
          "calibration.xml",
          xml(Flights.cameras(scene)).getBytes(StandardCharsets.UTF_8));
      add(zip, without, "cam_info.csv.gz", packed(info.toString()));
      add(zip, without, "data2d_distorted.csv.gz", packed(points.toString()));
      add(zip, without, "data_association.csv.gz", packed(whose.toString()));
    }
    return file;
  }

  private static void add(ZipOutputStream zip, String without, String name, byte[] bytes)
      throws IOException {
    if (!name.equals(without)) {
      zip.putNextEntry(new ZipEntry(name));
      zip.write(bytes);
      zip.closeEntry();
    }
  }

  @Test
  void observationsOfBraidzFilesAreFiltered() throws IOException {
    FlightScene scene = Flights.scene(3, 5, "run.startUs=1700000000000000");
    Path file = braidz(scene, 80, "");
    assertTrue(ObservationFile.hasCameras(file));
    ObservationFile read = ObservationFile.open(file, Optional.empty());
    assertEquals(1.4, read.cameras().minEccentricity());
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(read.cameras().cameras(), OrientationSettings.defaults());
    TreeMap<Long, List<LineObservation>> seen = new TreeMap<>();
    read.read(
        new ObservationFile.Listener() {
          @Override
          public void observed(long timeUs, String object, LineObservation line) {
            assertEquals("42", object);
            assertTrue(seen.isEmpty() || timeUs >= seen.lastKey(), "times ascend");
            seen.computeIfAbsent(timeUs, time -> new ArrayList<>()).add(line);
          }

          @Override
          public void skipped(String where, String why) {
            fail(where + " " + why);
          }
        });
    assertTrue(read.hasFrames());
    assertEquals(1, read.frame(scene.pictureTimeUs(1)));
    List<Double> errors = new ArrayList<>();
    seen.forEach(
        (timeUs, lines) ->
            body.update(timeUs, lines)
                .ifPresent(
                    now -> {
                      FlightScores scores = new FlightScores();
                      scores.note(now, scene.truthAt(timeUs), true);
                      errors.addAll(scores.lineDeg);
                    }));
    assertTrue(errors.size() > 70, errors.size() + " estimates");
    assertTrue(FlightScores.quantile(errors, 0.5) < 2.5);
  }

  @Test
  void missingPartsOfABraidzFileAreReported() throws IOException {
    FlightScene scene = Flights.scene(2, 5);
    for (String missing :
        List.of(
            "calibration.xml",
            "cam_info.csv.gz",
            "data2d_distorted.csv.gz",
            "data_association.csv.gz")) {
      Path file = braidz(scene, 3, missing);
      IOException problem =
          assertThrows(IOException.class, () -> ObservationFile.open(file, Optional.empty()));
      assertTrue(problem.getMessage().contains(missing), problem.getMessage());
      assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
    }
    Path cut = braidz(scene, 3, "");
    byte[] bytes = Files.readAllBytes(cut);
    Files.write(cut, java.util.Arrays.copyOf(bytes, bytes.length / 2));
    assertThrows(IOException.class, () -> ObservationFile.open(cut, Optional.empty()));
  }
}
