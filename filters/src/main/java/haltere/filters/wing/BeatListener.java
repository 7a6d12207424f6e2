package haltere.filters.wing;

/** Takes beats as they end. */
interface BeatListener {
  /**
   * A wing has passed its centre towards the tail.
   *
   * @param side which wing
   * @param timeUs when, microseconds, with fractions
   * @param periodUs since the last time; NaN the first time
   * @param leastRad least stroke angle of the beat
   * @param mostRad largest stroke angle of the beat
   */
  void beat(WingSide side, double timeUs, double periodUs, double leastRad, double mostRad);
}
