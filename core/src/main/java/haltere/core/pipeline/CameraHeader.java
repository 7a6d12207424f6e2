package haltere.core.pipeline;

import haltere.core.camera.Camera;
import haltere.core.camera.ClockRelation;
import haltere.core.camera.Configuration;
import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Metadata of the camera in the header of a recording:
 *
 * <ul>
 *   <li>{@code source}, its id, and {@code camera}, its own name;
 *   <li>{@code camera.NAME} and {@code camera.bias.NAME}, its settings and biases;
 *   <li>{@code chain}, the filters that the events have gone through, as a chain file;
 *   <li>{@code clockOffsetUs}, microseconds to add to a time of the recording to get the time of
 *       day (since 1970, UTC) on the computer that recorded it. Two cameras recorded on one
 *       computer relate by it, to about a millisecond.
 * </ul>
 *
 * <p>Thread rule: asked on the thread that hands over the camera's stream.
 *
 * @since 0.1
 */
public final class CameraHeader implements Supplier<Map<String, String>> {
  private final Camera camera;
  private final Supplier<Optional<String>> chain;
  private final LongSupplier nanoTime;
  private final Clock clock;

  /**
   * The header of a camera.
   *
   * @param camera an open camera
   * @param chain the chain as JSON, if there is one; asked each time
   * @param nanoTime the clock that the camera relates its own to
   * @param clock time of day
   */
  public CameraHeader(
      Camera camera, Supplier<Optional<String>> chain, LongSupplier nanoTime, Clock clock) {
    this.camera = Objects.requireNonNull(camera, "camera");
    this.chain = Objects.requireNonNull(chain, "chain");
    this.nanoTime = Objects.requireNonNull(nanoTime, "nanoTime");
    this.clock = Objects.requireNonNull(clock, "clock");
  }

  @Override
  public Map<String, String> get() {
    Map<String, String> lines = new TreeMap<>();
    camera
        .facet(Configuration.class)
        .ifPresent(configuration -> configuration.text().lines().forEach(line -> add(line, lines)));
    chain.get().ifPresent(json -> lines.put("chain", json.strip().replaceAll("\\s*\\n\\s*", " ")));
    clockOffsetUs().ifPresent(us -> lines.put("clockOffsetUs", Long.toString(us)));
    lines.put("source", camera.info().id());
    return lines;
  }

  private static void add(String line, Map<String, String> lines) {
    int equals = line.indexOf(" = ");
    if (equals > 0) {
      String name = line.substring(0, equals).strip();
      String key = name.equals("camera") ? name : "camera." + name;
      lines.put(key, line.substring(equals + 3).strip());
    }
  }

  /**
   * What has to be added to a time of the camera to get the time of day, as far as is known now.
   *
   * @return microseconds, or empty before the first event
   */
  public Optional<Long> clockOffsetUs() {
    return camera.clockRelation().map(this::offsetUs);
  }

  private long offsetUs(ClockRelation relation) {
    long nowUs = ChronoUnit.MICROS.between(Instant.EPOCH, clock.instant());
    long agoUs = Math.floorDiv(nanoTime.getAsLong() - relation.hostNanos(), 1000);
    return nowUs - agoUs - relation.cameraUs();
  }
}
