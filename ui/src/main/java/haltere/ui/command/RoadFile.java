package haltere.ui.command;

import haltere.core.json.Json;
import haltere.core.json.JsonProblem;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.filters.plane.RoadViewSettings;
import haltere.filters.track.RoadTracksSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * A road as JSON:
 *
 * <pre>{@code
 * {"bridgeHeightM": 5, "nearestM": 6, "farthestM": 300,
 *  "vanishingPoint": {"xPx": 63.5, "yPx": 127}}
 * }</pre>
 *
 * <p>What is left out has its default; the vanishing point is the middle of the top row then. Lanes
 * and counting lines of earlier versions are skipped with a note.
 */
final class RoadFile {
  private static final String VANISHING_POINT = "vanishingPoint";
  private static final List<String> SKIPPED = List.of("lanes", "countingLines");

  private RoadFile() {}

  /**
   * Reads a road.
   *
   * @param file JSON
   * @param usual what the file does not speak of
   * @param notes takes a line for what is skipped
   * @return tracks on that road
   * @throws JsonProblem if the file is not a road; the message names it
   * @throws IOException if it cannot be read
   */
  static RoadTracksSettings read(Path file, RoadTracksSettings usual, Consumer<String> notes)
      throws IOException {
    Object value = Json.read(file);
    if (!(value instanceof Map<?, ?> object)) {
      throw new JsonProblem(file + ": a road is a JSON object with keys such as bridgeHeightM");
    }
    Map<Object, Object> view = new LinkedHashMap<>(object);
    for (String name : SKIPPED) {
      if (view.remove(name) != null) {
        notes.accept(file + ": kalman-tracks has no " + name + ", skipped");
      }
    }
    if (view.get(VANISHING_POINT) instanceof Map<?, ?> point && !point.containsKey("marked")) {
      Map<Object, Object> marked = new LinkedHashMap<>(point);
      marked.put("marked", true);
      view.put(VANISHING_POINT, marked);
    }
    try {
      return new RoadTracksSettings(
          true,
          SettingsJson.fromMap(view, SettingsSchema.of(RoadViewSettings.class)),
          usual.processVariance());
    } catch (SettingsProblem problem) {
      throw new JsonProblem(file + ": " + problem.getMessage());
    }
  }
}
