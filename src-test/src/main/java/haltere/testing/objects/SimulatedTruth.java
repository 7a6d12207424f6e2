package haltere.testing.objects;

import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;

/**
 * Collects the truth of simulated objects. An object counts while half of it or more is visible,
 * and while it moves or has rested for less than {@value #AT_REST_S} s; else its region, a little
 * grown, is ignored. Thread rule: one thread at a time.
 */
final class SimulatedTruth {
  /** Time between two moments, microseconds. */
  static final long STEP_US = 20_000;

  private static final double AT_REST_S = 0.2;
  private static final double MIN_VISIBLE = 0.5;

  /** Share of its full speed below which an object makes hardly any events. */
  private static final double MIN_PACE = 0.05;

  private static final double GROWTH = 1.4;

  private final Box picture;
  private final List<TruthMoment> moments = new ArrayList<>();
  private List<TrueObject> there = new ArrayList<>();
  private List<Box> ignored = new ArrayList<>();

  SimulatedTruth(SensorGeometry geometry) {
    picture = new Box(-0.5, -0.5, geometry.width() - 0.5, geometry.height() - 0.5);
  }

  /** Adds an object to the moment, of which a share is visible so far as it is in the picture. */
  void add(TrueObject object, double visible, Motion motion, double s) {
    Box box = object.box();
    boolean moves = motion.pace(s) > MIN_PACE || motion.pace(s - AT_REST_S) > MIN_PACE;
    if (moves && Math.min(visible, box.shareIn(picture)) >= MIN_VISIBLE) {
      there.add(object);
    } else if (box.gapTo(picture) < 0) {
      ignored.add(
          Box.around(
              box.centreX(), box.centreY(), GROWTH * box.width() / 2, GROWTH * box.height() / 2));
    }
  }

  /** Ends the moment. */
  void end(long timeUs) {
    moments.add(new TruthMoment(timeUs, there, ignored));
    there = new ArrayList<>();
    ignored = new ArrayList<>();
  }

  List<TruthMoment> moments() {
    return moments;
  }
}
