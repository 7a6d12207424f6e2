package haltere.filters.track.kalman;

import haltere.filters.track.motion.MotionModes;

/** Tells where vehicles have come from, and which are none. Thread rule: that of its owner. */
interface WayBack {
  /**
   * Whether a vehicle that was found beyond a line was seen on its way from the line on.
   *
   * @param motion where the track is at the time
   */
  boolean leadsTo(Track track, MotionModes motion, double lineM, long timeUs);

  /**
   * Whether a track may be on a higher line of another vehicle that is there, as far as it seems.
   */
  boolean isOnOther(Track track, MotionModes motion, long timeUs);
}
