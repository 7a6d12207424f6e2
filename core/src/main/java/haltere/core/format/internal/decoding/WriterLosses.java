package haltere.core.format.internal.decoding;

import haltere.core.event.SensorGeometry;
import java.util.List;

/** Lines about what a writer left out, in the words that all formats share. */
public final class WriterLosses {
  private WriterLosses() {}

  /**
   * Reports events whose pixel is not on the sensor.
   *
   * @param events how many were left out, 0 or more
   * @param sensor the sensor that was written
   * @return a line, or none without such events
   */
  public static List<String> outside(long events, SensorGeometry sensor) {
    return events == 0
        ? List.of()
        : List.of(events + " events outside of " + sensor + " were left out");
  }
}
