package haltere.ui.viewer.feature;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import haltere.ui.viewer.session.SessionRequest;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a person has said of recordings, scenes and cameras, kept from one start to the next: the
 * chain of each, and the sensor of recordings that do not name theirs. Of many the ones that were
 * changed last are kept.
 *
 * <p>Thread rule: JavaFX thread only, or the thread that makes the window, before it is made.
 *
 * @param settings hold it
 */
public record SourceMemory(UserSettings settings) {
  private static final String CHAINS = "chains";
  private static final String SENSORS = "sensors";
  private static final int MAX_CHAINS = 40;
  private static final int MAX_SENSORS = 400;

  /** The chain of its own that something has, as JSON; empty where nobody has changed it. */
  public Optional<String> chain(SessionRequest request) {
    return Optional.ofNullable(settings.map(CHAINS).get(request.chainKey())).map(Json::write);
  }

  /** Keeps a chain as saved JSON; empty where it is the one to begin with. */
  void keepChain(SessionRequest request, Optional<String> json) {
    Map<String, Object> chains = settings.map(CHAINS);
    if (chains.remove(request.chainKey()) == null && json.isEmpty()) {
      return;
    }
    json.ifPresent(chain -> chains.put(request.chainKey(), parsed(chain)));
    put(CHAINS, chains, MAX_CHAINS);
  }

  /** Keeps the sensor of a recording that does not name it. */
  void keepSensor(SessionRequest request, SensorGeometry sensor) {
    Map<String, Object> sensors = settings.map(SENSORS);
    sensors.remove(request.chainKey());
    sensors.put(
        request.chainKey(),
        List.of((long) sensor.width(), (long) sensor.height(), sensor.origin().name()));
    put(SENSORS, sensors, MAX_SENSORS);
  }

  /** The same request with the sensor that was kept for it, unless it names one. */
  public SessionRequest withSensor(SessionRequest request) {
    if (request.file().isPresent()
        && request.options().sensor().isEmpty()
        && settings.map(SENSORS).get(request.chainKey()) instanceof List<?> kept
        && kept.size() == 3
        && kept.get(0) instanceof Long width
        && kept.get(1) instanceof Long height) {
      try {
        SensorGeometry sensor =
            new SensorGeometry(
                Math.toIntExact(width),
                Math.toIntExact(height),
                Origin.valueOf(kept.get(2).toString()));
        return SessionRequest.recording(request.file().get(), request.options().withSensor(sensor));
      } catch (IllegalArgumentException | ArithmeticException ofNoUse) {
        return request;
      }
    }
    return request;
  }

  private void put(String name, Map<String, Object> values, int most) {
    values.keySet().stream()
        .limit(Math.max(0, values.size() - most))
        .toList()
        .forEach(values::remove);
    settings.put(name, values);
  }

  private static Object parsed(String json) {
    try {
      return Json.parse(json, "a chain");
    } catch (JsonProblem impossible) {
      throw new IllegalStateException(impossible);
    }
  }
}
