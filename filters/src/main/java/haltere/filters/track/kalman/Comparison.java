package haltere.filters.track.kalman;

import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.motion.MotionNoise;

/**
 * Room for what the track that was compared last has predicted. All tracks share one, so that it is
 * near at hand: a track that takes in what it has compared goes on with it and leaves its own
 * behind. Thread rule: that of its owner.
 */
final class Comparison {
  MotionModes ahead;

  Comparison(MotionNoise noise) {
    ahead = new MotionModes(noise);
  }
}
