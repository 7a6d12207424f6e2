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

  /**
   * Names the difference between times read back and those written.
   *
   * @param missingUs what the times read back lack, not 0
   * @return such as "smaller by 5 us", or "larger by 5 us" for -5
   */
  public static String shift(long missingUs) {
    return (missingUs < 0 ? "larger by " : "smaller by ") + Math.abs(missingUs) + " us";
  }
}
