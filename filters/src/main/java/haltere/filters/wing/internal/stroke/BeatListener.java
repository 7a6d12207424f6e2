package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/**
 * Takes beats as they end.
 *
 * <p>Thread rule: it is told on the thread that hands over events.
 */
public interface BeatListener {
  /**
   * A wing has passed its centre towards the tail.
   *
   * @param side which wing
   * @param timeUs when, microseconds, with fractions
   * @param periodUs since the last time; NaN the first time
   * @param leastRad least stroke angle of the beat
   * @param mostRad largest stroke angle of the beat
   */
  void beat(WingPart side, double timeUs, double periodUs, double leastRad, double mostRad);
}
