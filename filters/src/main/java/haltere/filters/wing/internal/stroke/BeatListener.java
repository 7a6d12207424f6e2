package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/** Receives beats at their end, on the thread of the events. */
public interface BeatListener {
  /**
   * A wing has passed its centre towards the tail.
   *
   * @param side which wing
   * @param timeUs microseconds, with fractions
   * @param periodUs since the last beat; NaN for the first one
   * @param minRad smallest stroke angle of the beat
   * @param maxRad largest stroke angle of the beat
   */
  void beat(WingPart side, double timeUs, double periodUs, double minRad, double maxRad);
}
