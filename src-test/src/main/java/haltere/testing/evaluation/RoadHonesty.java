package haltere.testing.evaluation;

import haltere.core.simulation.road.RoadTruth;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadTrackPoint;
import haltere.filters.track.TrackUpdate;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Whether tracks on a road are as sure as they say: how many errors are within the 95 % of their
 * standard deviation, and how many innovations within those of their covariance. Neighbouring
 * estimates of a vehicle share their errors, so of each passage only the one in the middle is
 * taken, and of each track one innovation.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
final class RoadHonesty {
  /** 95 % of the squares of one and of two independent normal numbers are below. */
  private static final double CHI_SQUARE_1 = 3.841;

  private static final double CHI_SQUARE_2 = 5.991;
  private static final int WHICH_INNOVATION = 5;

  private record Errors(double speed, double along, double across) {}

  private final Map<Integer, List<Errors>> passages = new HashMap<>();
  private final Map<Integer, Integer> updates = new HashMap<>();
  private final Share speed = new Share();
  private final Share along = new Share();
  private final Share across = new Share();
  private final Share innovations = new Share();

  /** Compares an estimate with the truth, the end of a vehicle that is nearer to the camera. */
  void add(RoadTrackPoint track, RoadTruth vehicle, RoadMapping road) {
    double trueKmH = 3.6 * Math.hypot(vehicle.vxMS(), vehicle.vyMS());
    double row = vehicle.yPx() - vehicle.heightPx() / 2;
    passages
        .computeIfAbsent(vehicle.id(), id -> new ArrayList<>())
        .add(
            new Errors(
                square(track.speedKmH() - trueKmH, track.sdSpeedKmH()),
                square(track.yM() - road.distanceM(row), track.sdYM()),
                square(track.xM() - vehicle.xM(), track.sdXM())));
  }

  private static double square(double error, double sd) {
    return error * error / (sd * sd);
  }

  /** Takes a step of a filter. */
  void add(TrackUpdate update) {
    if (update.accepted() && updates.merge(update.id(), 1, Integer::sum) == WHICH_INNOVATION) {
      innovations.add(update.nis(), CHI_SQUARE_2);
    }
  }

  /** Ends a scene. */
  void endScene() {
    for (List<Errors> passage : passages.values()) {
      Errors middle = passage.get(passage.size() / 2);
      speed.add(middle.speed(), CHI_SQUARE_1);
      along.add(middle.along(), CHI_SQUARE_1);
      across.add(middle.across(), CHI_SQUARE_1);
    }
    passages.clear();
    updates.clear();
  }

  /** Errors of the speed, of one estimate of each passage. */
  Share speed() {
    return speed;
  }

  /** Errors of the place along the road. */
  Share along() {
    return along;
  }

  /** Errors of the place across the road. */
  Share across() {
    return across;
  }

  /** Innovations of rows that were passed, one of each track. */
  Share innovations() {
    return innovations;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "within their 95 %% (by chance +-%.1f): speeds %.1f, places along %.1f, across %.1f of %d"
            + " passages; innovations (+-%.1f) %.1f of %d tracks%n",
        100 * speed.chance(),
        100 * speed.within(),
        100 * along.within(),
        100 * across.within(),
        speed.count(),
        100 * innovations.chance(),
        100 * innovations.within(),
        innovations.count());
  }
}
