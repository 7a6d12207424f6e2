package haltere.filters.orientation.camera;

import haltere.core.json.JsonProblem;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * Cameras of a {@code multi_camera_reconstructor}, as Flydra and Braid write them: for each {@code
 * single_camera_calibration} its {@code cam_id}, {@code calibration_matrix} (rows separated by
 * semicolons), {@code resolution} and {@code non_linear_parameters}, of which fc1, fc2, cc1, cc2
 * and alpha_c map a pixel to normalised coordinates, k1, k2, p1, p2 (and k3) are the distortion,
 * and fc1p, fc2p, cc1p, cc2p, if present, must be the same: the matrix is then that of the
 * undistorted picture.
 */
final class CameraXml {
  private static final String CAMERA = "single_camera_calibration";
  private static final List<String> LENS = List.of("fc1", "fc2", "cc1", "cc2");

  private CameraXml() {}

  static CameraFile read(InputStream in, String name) throws JsonProblem {
    XMLInputFactory factory = XMLInputFactory.newInstance();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    List<CameraModel> cameras = new ArrayList<>();
    double[] minEccentricity = new double[1];
    try {
      XMLStreamReader xml = factory.createXMLStreamReader(in);
      Map<String, String> camera = new HashMap<>();
      StringBuilder text = new StringBuilder();
      while (xml.hasNext()) {
        int event = xml.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
          text.setLength(0);
          if (xml.getLocalName().equals(CAMERA)) {
            camera.clear();
          }
        } else if (event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA) {
          text.append(xml.getText());
        } else if (event == XMLStreamConstants.END_ELEMENT) {
          String element = xml.getLocalName();
          if (element.equals(CAMERA)) {
            cameras.add(camera(camera, name + ": camera " + (cameras.size() + 1)));
          } else if (element.equals("minimum_eccentricity")) {
            minEccentricity[0] = number(text.toString(), name + ": " + element);
          } else {
            camera.put(element, text.toString().strip());
          }
          text.setLength(0);
        }
      }
    } catch (XMLStreamException broken) {
      int line = broken.getLocation() == null ? 0 : broken.getLocation().getLineNumber();
      throw new JsonProblem(name + ": line " + line + ": this is not well-formed XML");
    }
    return CameraFile.checked(cameras, name, minEccentricity[0]);
  }

  private static CameraModel camera(Map<String, String> camera, String name) throws JsonProblem {
    String id = camera.get("cam_id");
    String matrixText = camera.get("calibration_matrix");
    if (id == null || matrixText == null) {
      throw new JsonProblem(name + " has no cam_id or no calibration_matrix");
    }
    double[] matrix = new double[12];
    for (int i = 0; i < 12; i++) {
      String[] rows = matrixText.split(";");
      String[] words = rows[Math.min(i / 4, rows.length - 1)].strip().split("\\s+");
      if (rows.length != 3 || words.length != 4) {
        throw new JsonProblem(
            name + ": calibration_matrix needs 3 rows of 4 numbers with semicolons");
      }
      matrix[i] = number(words[i % 4], name + ": calibration_matrix");
    }
    String[] size = camera.getOrDefault("resolution", "0 0").split("\\s+");
    int width = (int) number(size[0], name + ": resolution");
    int height = size.length > 1 ? (int) number(size[1], name + ": resolution") : 0;
    if (!camera.containsKey("fc1")) {
      return CameraModel.of(id, matrix, new double[0], width, height);
    }
    double[] own = new double[4];
    for (int i = 0; i < 4; i++) {
      own[i] = field(camera, LENS.get(i), Double.NaN, name);
      requireSame(camera, LENS.get(i) + "p", own[i], name);
    }
    double fx = own[0];
    if (!(fx > 0 && own[1] > 0) || !Double.isFinite(own[2] + own[3])) {
      throw new JsonProblem(name + ": fc1, fc2, cc1 and cc2 are required, fc1 and fc2 positive");
    }
    Lens lens =
        new Lens(
            fx,
            own[1],
            field(camera, "alpha_c", 0, name) * fx,
            own[2],
            own[3],
            field(camera, "k1", 0, name),
            field(camera, "k2", 0, name),
            field(camera, "p1", 0, name),
            field(camera, "p2", 0, name),
            field(camera, "k3", 0, name));
    return CameraModel.of(id, matrix, lens, width, height);
  }

  private static void requireSame(
      Map<String, String> camera, String key, double expected, String name) throws JsonProblem {
    double value = field(camera, key, expected, name);
    if (Math.abs(value - expected) > 1e-6 * (1 + Math.abs(expected))) {
      throw new JsonProblem(
          name + ": " + key + " differs from its value without p; rectified pictures are not read");
    }
  }

  private static double field(Map<String, String> camera, String key, double absent, String name)
      throws JsonProblem {
    String text = camera.get(key);
    return text == null ? absent : number(text, name + ": " + key);
  }

  private static double number(String text, String name) throws JsonProblem {
    try {
      return Double.parseDouble(text.strip());
    } catch (NumberFormatException noNumber) {
      throw new JsonProblem(name + " is \"" + text.strip() + "\", it must be a number");
    }
  }
}
