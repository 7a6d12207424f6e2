package haltere.filters.track.kalman;

import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.MeasurementSettings;
import haltere.filters.track.motion.MotionNoise;

/** A track on a road, alone. */
final class GivenTrack {
  private static final double PROCESS_VARIANCE = 0.02;

  private GivenTrack() {}

  static Track in(MeasurementPlane plane) {
    MotionNoise noise =
        MotionNoise.onRoad(KalmanTracksSettings.defaults().motion(), PROCESS_VARIANCE);
    return new Track(noise, plane, MeasurementSettings.defaults(), new Comparison(noise));
  }
}
