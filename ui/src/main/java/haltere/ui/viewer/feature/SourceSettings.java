package haltere.ui.viewer.feature;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.json.internal.Json;
import haltere.core.sink.internal.Unchecked;
import haltere.ui.viewer.session.SessionRequest;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Saved settings of sources: the chain of recordings, scenes and cameras, and the sensor of
 * recordings that do not state it. The most recently changed ones are kept.
 *
 * <p>Thread rule: JavaFX thread only, or the thread that makes the window, before it is made.
 *
 * @param settings hold it
 */
public record SourceSettings(UserSettings settings) {
  private static final String CHAINS = "chains";
  private static final String SENSORS = "sensors";
  private static final int MAX_CHAINS = 40;
  private static final int MAX_SENSORS = 400;

  /** The saved chain of a source, as JSON; empty if nobody has changed it. */
  public Optional<String> chain(SessionRequest request) {
    return Optional.ofNullable(settings.map(CHAINS).get(request.chainKey())).map(Json::write);
  }

  /** Saves a chain as JSON; empty for the default one. */
  void saveChain(SessionRequest request, Optional<String> json) {
    Map<String, Object> chains = settings.map(CHAINS);
    if (chains.remove(request.chainKey()) == null && json.isEmpty()) {
      return;
    }
    json.ifPresent(
        chain ->
            chains.put(request.chainKey(), Unchecked.read(() -> Json.parse(chain, "a chain"))));
    put(CHAINS, chains, MAX_CHAINS);
  }

  /** Keeps the sensor of a recording that does not name it. */
  void saveSensor(SessionRequest request, SensorGeometry sensor) {
    Map<String, Object> sensors = settings.map(SENSORS);
    sensors.remove(request.chainKey());
    sensors.put(
        request.chainKey(),
        List.of((long) sensor.width(), (long) sensor.height(), sensor.origin().name()));
    put(SENSORS, sensors, MAX_SENSORS);
  }

  /** The same request with the saved sensor, unless it states one. */
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

  private void put(String name, Map<String, Object> values, int maxCount) {
    values.keySet().stream()
        .limit(Math.max(0, values.size() - maxCount))
        .toList()
        .forEach(values::remove);
    settings.put(name, values);
  }
}
