package haltere.core.format.internal.decoding;

import haltere.core.event.SensorGeometry;
import java.util.List;

/** Messages about what a written recording lacks, shared by all formats. */
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
    String was = events == 1 ? " was left out" : " were left out";
    return line(events, "event", "outside of " + sensor + was);
  }

  /**
   * Reports jumps of time that a format's clock cannot express.
   *
   * @param jumps number of jumps
   * @param clock the clock, such as "the format's clock"
   * @return a line, or none without such jumps
   */
  public static List<String> jumps(long jumps, String clock) {
    String fits = jumps == 1 ? "of time does not fit " : "of time do not fit ";
    return line(jumps, "jump", fits + clock + "; later times read back shifted");
  }

  private static List<String> line(long count, String noun, String rest) {
    String nouns = count == 1 ? noun : noun + "s";
    return count == 0 ? List.of() : List.of(count + " " + nouns + " " + rest);
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
