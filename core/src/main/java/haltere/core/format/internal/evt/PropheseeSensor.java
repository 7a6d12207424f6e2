package haltere.core.format.internal.evt;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.internal.decoding.SensorGuess;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Determines the sensor size of a Prophesee file: from the header's size, else the user's options,
 * else the camera in the header, else the smallest existing sensor that holds the events. Rows
 * count from the top.
 *
 * @param geometry the sensor
 * @param remark origin of the size if the file does not state it; empty if it does
 */
public record PropheseeSensor(SensorGeometry geometry, Optional<String> remark) {
  private static final SensorGeometry GEN3 = SensorGuess.top(640, 480);
  private static final SensorGeometry GEN4 = SensorGuess.top(1280, 720);

  /** Sizes of the sensors of RAW files. */
  static final List<SensorGeometry> RAW_SIZES =
      List.of(SensorGuess.top(320, 320), SensorGuess.top(480, 360), GEN3, GEN4);

  /**
   * Determines the sensor.
   *
   * @param header of the file
   * @param options the user's options
   * @param maxSide maximum columns and rows that the format can address
   * @param sizes existing sensors, from the smallest to the usual one
   * @param events the events, some of which are read if the size is not known otherwise
   * @return the sensor
   * @throws IOException if the file cannot be read
   */
  public static PropheseeSensor decide(
      PropheseeHeader header,
      ReadOptions options,
      int maxSide,
      List<SensorGeometry> sizes,
      SensorGuess.CursorsBySensor events)
      throws IOException {
    Optional<PropheseeHeader.Size> stated = header.size();
    String warning = "";
    if (stated.isPresent()) {
      PropheseeHeader.Size size = stated.get();
      if (size.width() >= 1
          && size.height() >= 1
          && size.width() <= maxSide
          && size.height() <= maxSide) {
        return new PropheseeSensor(SensorGuess.top(size.width(), size.height()), Optional.empty());
      }
      warning = "the header's size " + size.width() + "x" + size.height() + " is impossible; ";
    }
    if (options.sensor().isPresent()) {
      SensorGeometry given = options.sensor().get();
      return new PropheseeSensor(
          SensorGuess.top(given.width(), given.height()),
          warning.isEmpty()
              ? Optional.empty()
              : Optional.of(warning + given + " is used as asked for"));
    }
    Optional<SensorGeometry> named = named(header);
    if (named.isPresent()) {
      return new PropheseeSensor(
          named.get(),
          Optional.of(
              warning + "no size is stated; the camera is one of " + named.get() + " pixels"));
    }
    return guessed(events, maxSide, sizes, warning);
  }

  /** The sensor of the camera named in a RAW header. */
  private static Optional<SensorGeometry> named(PropheseeHeader header) {
    String plugin = header.value("plugin_name").orElse("").toLowerCase(Locale.ROOT);
    String generation = header.value("sensor_generation").orElse("");
    if (plugin.contains("genx320") || header.value("sensor_name").orElse("").contains("320")) {
      return Optional.of(RAW_SIZES.get(0));
    }
    if (plugin.contains("gen31") || generation.equals("3.1")) {
      return Optional.of(GEN3);
    }
    if (plugin.contains("gen4") || plugin.contains("imx636") || generation.startsWith("4.")) {
      return Optional.of(GEN4);
    }
    return Optional.empty();
  }

  private static PropheseeSensor guessed(
      SensorGuess.CursorsBySensor events, int maxSide, List<SensorGeometry> sizes, String warning)
      throws IOException {
    Optional<SensorGeometry> guess =
        SensorGuess.smallest(events.open(SensorGuess.square(maxSide)), maxSide, sizes);
    SensorGeometry fallback = sizes.get(sizes.size() - 1);
    return guess
        .map(size -> new PropheseeSensor(size, Optional.of(warning + SensorGuess.remark(size))))
        .orElseGet(
            () ->
                new PropheseeSensor(
                    fallback,
                    Optional.of(
                        warning
                            + "no size is stated and no event is there; "
                            + fallback
                            + " taken")));
  }
}
