package haltere.ui.command;

import haltere.core.json.Json;
import haltere.core.json.JsonProblem;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.filters.plane.RoadViewSettings;
import haltere.filters.road.CountingLineSettings;
import haltere.filters.road.LaneSettings;
import haltere.filters.track.RoadTracksSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A road as JSON:
 *
 * <pre>{@code
 * {"bridgeHeightM": 5, "nearestM": 6, "farthestM": 300,
 *  "vanishingPoint": {"xPx": 63.5, "yPx": 127},
 *  "lanes": {"lanes": 4, "leftEdgeM": -7, "widthM": 3.5},
 *  "countingLines": {"lines": 2, "firstM": 20, "apartM": 20}}
 * }</pre>
 *
 * <p>What is left out has its default: no lanes, no lines, the vanishing point in the middle of the
 * top row.
 *
 * @param view how the camera sees the road
 * @param lanes its lanes
 * @param lines its counting lines
 */
record RoadFile(RoadViewSettings view, LaneSettings lanes, CountingLineSettings lines) {
  private static final String VANISHING_POINT = "vanishingPoint";
  private static final String LANES = "lanes";
  private static final String LINES = "countingLines";

  /**
   * Reads a road.
   *
   * @param file JSON
   * @return the road
   * @throws JsonProblem if the file is not a road; the message names it
   * @throws IOException if it cannot be read
   */
  static RoadFile read(Path file) throws IOException {
    Object value = Json.read(file);
    if (!(value instanceof Map<?, ?> object)) {
      throw new JsonProblem(file + ": a road is a JSON object with keys such as bridgeHeightM");
    }
    try {
      return road(object);
    } catch (SettingsProblem problem) {
      throw new JsonProblem(file + ": " + problem.getMessage());
    }
  }

  private static RoadFile road(Map<?, ?> object) {
    Map<Object, Object> view = new LinkedHashMap<>(object);
    Object lanes = view.remove(LANES);
    Object lines = view.remove(LINES);
    if (view.get(VANISHING_POINT) instanceof Map<?, ?> point && !point.containsKey("marked")) {
      Map<Object, Object> marked = new LinkedHashMap<>(point);
      marked.put("marked", true);
      view.put(VANISHING_POINT, marked);
    }
    return new RoadFile(
        SettingsJson.fromMap(view, SettingsSchema.of(RoadViewSettings.class)),
        part(LANES, lanes, LaneSettings.class),
        part(LINES, lines, CountingLineSettings.class));
  }

  private static <S extends Record> S part(String name, Object value, Class<S> type) {
    SettingsSchema<S> schema = SettingsSchema.of(type);
    if (value == null) {
      return schema.defaults();
    }
    if (!(value instanceof Map<?, ?> object)) {
      throw new SettingsProblem(
          "\""
              + name
              + "\" is an object with "
              + schema.parameters().stream().map(Parameter::name).toList());
    }
    return SettingsJson.fromMap(object, schema);
  }

  /** Tracks on this road, with the process noise of others. */
  RoadTracksSettings tracks(RoadTracksSettings usual) {
    return new RoadTracksSettings(true, view, usual.processVariance());
  }
}
