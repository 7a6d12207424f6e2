package haltere.core.format.internal.decoding;

import haltere.core.event.SensorGeometry;
import java.util.List;

/** Messages about events that a writer skipped, shared by all formats. */
public final class WriterLosses {
  private WriterLosses() {}

  /**
   * Reports events outside the sensor.
   *
   * @param events number of skipped events
   * @param sensor the written sensor
   * @return a line, or none without such events
   */
  public static List<String> outside(long events, SensorGeometry sensor) {
    return events == 0
        ? List.of()
        : List.of(events + " events outside of " + sensor + " were left out");
  }
}
