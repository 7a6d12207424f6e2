package haltere.ui.command;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.Cameras;
import haltere.core.json.internal.Json;
import haltere.ui.command.terminal.Quantities;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Lists the cameras. */
@Command(
    name = "devices",
    description = {
      "List the cameras that are seen, also those that cannot be opened, with the reason.",
      "Simulated cameras stand behind those that are plugged in."
    })
final class DevicesCommand extends Subcommand {
  @Option(
      names = "--json",
      description =
          "Write a JSON object whose key devices is an array: id, model, serial, width, height,"
              + " canOpen, note; obstacles says what keeps cameras from being seen.")
  boolean json;

  private final Cameras cameras;

  DevicesCommand(Surroundings surroundings) {
    this(surroundings, Cameras.installed());
  }

  DevicesCommand(Surroundings surroundings, Cameras cameras) {
    super(surroundings);
    this.cameras = cameras;
  }

  @Override
  public Integer call() {
    List<CameraInfo> seen = cameras.list();
    if (json) {
      Map<String, Object> object = new LinkedHashMap<>();
      object.put("devices", seen.stream().map(DevicesCommand::object).toList());
      object.put("obstacles", cameras.obstacles());
      result(Json.write(object));
    } else {
      print(seen);
      cameras.obstacles().forEach(this::warning);
    }
    return OK;
  }

  private static Map<String, Object> object(CameraInfo camera) {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("id", camera.id());
    object.put("model", camera.model());
    object.put("serial", camera.serial());
    object.put("width", camera.geometry().width());
    object.put("height", camera.geometry().height());
    object.put("canOpen", camera.canOpen());
    object.put("note", camera.note());
    return object;
  }

  private void print(List<CameraInfo> seen) {
    if (seen.isEmpty()) {
      result("no camera is seen");
      return;
    }
    List<String[]> rows = new ArrayList<>();
    for (CameraInfo camera : seen) {
      rows.add(new String[] {camera.id(), camera.model(), camera.geometry().toString()});
    }
    int[] widths = new int[3];
    for (String[] row : rows) {
      for (int i = 0; i < row.length; i++) {
        widths[i] = Math.max(widths[i], row[i].length());
      }
    }
    String form = "%-" + widths[0] + "s  %-" + widths[1] + "s  %-" + widths[2] + "s  %s";
    for (int i = 0; i < rows.size(); i++) {
      CameraInfo camera = seen.get(i);
      Object[] row = rows.get(i);
      String note = camera.note().strip().replaceAll("\\s*\\R\\s*", " ");
      result(
          Quantities.text(
                  form,
                  row[0],
                  row[1],
                  row[2],
                  camera.canOpen() ? note : "cannot be opened: " + note)
              .stripTrailing());
    }
  }
}
