package haltere.ui.command;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.Cameras;
import haltere.core.json.internal.Json;
import haltere.ui.command.terminal.Quantities;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Lists the cameras. */
@Command(
    name = "devices",
    description = {
      "List the cameras, and for each that cannot be opened the reason.",
      "Connected cameras come first, then simulated ones."
    })
final class DevicesCommand extends Subcommand {
  @Option(
      names = "--json",
      description =
          "Write a JSON object. Its key devices is an array: id, model, serial, width, height, "
              + "canOpen, note; its key obstacles lists what prevents cameras from being found.")
  boolean json;

  @Override
  public Integer call() {
    Cameras cameras = Cameras.installed();
    List<CameraInfo> seen = cameras.list();
    if (json) {
      Map<String, Object> object = new LinkedHashMap<>();
      object.put("devices", seen.stream().map(DevicesCommand::object).toList());
      object.put("obstacles", cameras.obstacles());
      result(Json.write(object));
    } else {
      if (seen.isEmpty()) {
        result("no camera found");
      }
      Quantities.table("", seen.stream().map(DevicesCommand::row).toList()).forEach(this::result);
      cameras.obstacles().forEach(this::warning);
    }
    return OK;
  }

  private static List<String> row(CameraInfo camera) {
    String note = camera.note().strip().replaceAll("\\s*\\R\\s*", " ");
    return List.of(
        camera.id(),
        camera.model(),
        camera.geometry().toString(),
        camera.canOpen() ? note : "cannot be opened: " + note);
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
}
