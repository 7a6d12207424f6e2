package haltere.ui.command;

import haltere.core.event.SensorGeometry;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.filters.object.MotionModel;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.Homography;
import haltere.filters.plane.PlanePoint;
import haltere.filters.plane.PointPair;
import haltere.filters.plane.RoadMapping;
import haltere.filters.plane.RoadViewSettings;
import haltere.filters.road.CountingLineSettings;
import haltere.filters.road.LaneSettings;
import haltere.filters.road.ObjectsOnPlane;
import haltere.filters.road.RoadMotion;
import haltere.filters.road.VehiclePrior;
import haltere.filters.road.VehiclesOnRoad;
import haltere.filters.track.RoadTracksSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A road as JSON:
 *
 * <pre>{@code
 * {"bridgeHeightM": 5, "nearestM": 6, "farthestM": 300,
 *  "vanishingPoint": {"xPx": 63.5, "yPx": 127},
 *  "lanes": {"lanes": 4, "leftEdgeM": -7, "widthM": 3.5},
 *  "countingLines": {"lines": 2, "firstM": 20, "spacingM": 20},
 *  "vehicles": {"speedMS": 25, "heightM": 1.6}}
 * }</pre>
 *
 * <p>What is left out has its default: no lanes, no lines, the vanishing point in the middle of the
 * top row, vehicles of all kinds.
 *
 * <p>Any other plane, such as an arena that is seen from above, is given by four points:
 *
 * <pre>{@code
 * {"points": [{"xPx": 10, "yPx": 12, "xM": 0, "yM": 0}, ...]}
 * }</pre>
 *
 * @param view how the camera sees the road
 * @param lanes its lanes
 * @param lines its counting lines
 * @param vehicles prior of its vehicles
 * @param points pixels with known positions; none for a road
 */
record RoadFile(
    RoadViewSettings view,
    LaneSettings lanes,
    CountingLineSettings lines,
    VehiclePrior vehicles,
    List<PointPair> points) {
  /**
   * Reads a road from a JSON file; a {@link JsonProblem} names a file that is none.
   *
   * @param notes receives a line for each object with settings of an earlier version
   */
  static RoadFile read(Path file, Consumer<String> notes) throws IOException {
    Object value = Json.read(file);
    if (!(value instanceof Map<?, ?> object)) {
      throw new JsonProblem(file + ": a road is a JSON object with keys such as bridgeHeightM");
    }
    try {
      return road(object, note -> notes.accept(file + ": " + note));
    } catch (SettingsProblem problem) {
      throw new JsonProblem(file + ": " + problem.getMessage());
    }
  }

  private static RoadFile road(Map<?, ?> object, Consumer<String> notes) {
    Map<Object, Object> view = new LinkedHashMap<>(object);
    LaneSettings lanes = part(view, "lanes", LaneSettings.class, notes);
    CountingLineSettings lines = part(view, "countingLines", CountingLineSettings.class, notes);
    VehiclePrior vehicles = part(view, "vehicles", VehiclePrior.class, notes);
    List<PointPair> points = points(view.remove("points"));
    if (view.get("vanishingPoint") instanceof Map<?, ?> point && !point.containsKey("marked")) {
      Map<Object, Object> marked = new LinkedHashMap<>(point);
      marked.put("marked", true);
      view.put("vanishingPoint", marked);
    }
    SettingsSchema<RoadViewSettings> schema = SettingsSchema.of(RoadViewSettings.class);
    return new RoadFile(SettingsJson.fromMap(view, schema, notes), lanes, lines, vehicles, points);
  }

  private static List<PointPair> points(Object value) {
    if (value == null) {
      return List.of();
    }
    if (!(value instanceof List<?> list)) {
      throw new SettingsProblem("\"points\" is an array of {xPx, yPx, xM, yM}");
    }
    List<PointPair> points = list.stream().map(RoadFile::pair).toList();
    try {
      new Homography(points);
    } catch (IllegalArgumentException problem) {
      throw new SettingsProblem("\"points\": " + problem.getMessage());
    }
    return points;
  }

  private static PointPair pair(Object point) {
    return new PointPair(
        number(point, "xPx"), number(point, "yPx"), number(point, "xM"), number(point, "yM"));
  }

  private static double number(Object point, String name) {
    if (point instanceof Map<?, ?> object && object.get(name) instanceof Number number) {
      return number.doubleValue();
    }
    throw new SettingsProblem("\"points\": each has the numbers xPx, yPx, xM, yM, not " + point);
  }

  /** How objects are mapped to metres. */
  Function<ObjectTrack, Optional<PlanePoint>> objects(SensorGeometry sensor) {
    return points.isEmpty()
        ? new VehiclesOnRoad(new RoadMapping(view, sensor), vehicles)
        : new ObjectsOnPlane(new Homography(points));
  }

  /** How objects move in the picture. */
  MotionModel motion(SensorGeometry sensor) {
    return points.isEmpty()
        ? new RoadMotion(new RoadMapping(view, sensor), vehicles)
        : new MotionModel();
  }

  private static <S extends Record> S part(
      Map<?, ?> object, String name, Class<S> type, Consumer<String> notes) {
    Object value = object.remove(name);
    SettingsSchema<S> schema = SettingsSchema.of(type);
    if (value == null) {
      return schema.defaults();
    }
    if (!(value instanceof Map<?, ?> settings)) {
      List<String> keys = schema.parameters().stream().map(Parameter::name).toList();
      throw new SettingsProblem("\"" + name + "\" is an object with " + keys);
    }
    return SettingsJson.fromMap(settings, schema, notes);
  }

  /** Tracks on this road, with the process noise of others. */
  RoadTracksSettings tracks(RoadTracksSettings usual) {
    return new RoadTracksSettings(true, view, usual.processVariance());
  }
}
