package haltere.testing.objects;

import java.util.ArrayList;
import java.util.List;

/**
 * Velocities of labelled objects: the slope of the least-squares line through the centres of an
 * object's boxes, from 60 ms before a moment to 60 ms after it, or from the label before to the
 * label after it where labels are rarer. A box follows the shape as well, so the velocity of a
 * walker is that of its box.
 */
final class LabelVelocities {
  /** Short against the period of a pendulum or of a step, long against the error of a box. */
  private static final long REACH_US = 60_000;

  /** Labels further apart say nothing about a velocity between them. */
  private static final long MAX_GAP_US = 200_000;

  private final List<TruthMoment> truth;

  private LabelVelocities(List<TruthMoment> truth) {
    this.truth = truth;
  }

  /**
   * Fills in what is unknown.
   *
   * @param truth in the order of time
   * @return the same boxes; velocities stay unknown without a label before and one after
   */
  static List<TruthMoment> of(List<TruthMoment> truth) {
    return new LabelVelocities(truth).all();
  }

  private List<TruthMoment> all() {
    List<TruthMoment> known = new ArrayList<>(truth.size());
    for (int i = 0; i < truth.size(); i++) {
      TruthMoment moment = truth.get(i);
      List<TrueObject> objects = new ArrayList<>();
      for (TrueObject object : moment.objects()) {
        objects.add(Double.isNaN(object.vxPxS()) ? at(i, object) : object);
      }
      known.add(new TruthMoment(moment.timeUs(), objects, moment.ignored()));
    }
    return known;
  }

  private TrueObject at(int moment, TrueObject object) {
    Line line = new Line(truth.get(moment).timeUs(), object.box());
    boolean isBetween = add(moment, -1, object.id(), line) && add(moment, 1, object.id(), line);
    return isBetween
        ? new TrueObject(object.id(), object.box(), line.slope(line.sumX), line.slope(line.sumY))
        : object;
  }

  /** Adds the labels on one side; returns whether there is any. */
  private boolean add(int moment, int step, int id, Line line) {
    boolean isFound = false;
    for (int i = moment + step; i >= 0 && i < truth.size(); i += step) {
      long gapUs = Math.abs(truth.get(i).timeUs() - line.originUs);
      if (gapUs > (isFound ? REACH_US : MAX_GAP_US)) {
        break;
      }
      for (TrueObject object : truth.get(i).objects()) {
        if (object.id() == id) {
          line.add(truth.get(i).timeUs(), object.box());
          isFound = true;
        }
      }
    }
    return isFound;
  }

  /** Sums of a least-squares line about its first point, so that rest is exactly 0. */
  private static final class Line {
    private final long originUs;
    private final Box origin;
    private final double[] sumX = new double[2];
    private final double[] sumY = new double[2];
    private double n = 1;
    private double sumT;
    private double sumTt;

    Line(long originUs, Box origin) {
      this.originUs = originUs;
      this.origin = origin;
    }

    void add(long timeUs, Box box) {
      double t = (timeUs - originUs) * 1e-6;
      n++;
      sumT += t;
      sumTt += t * t;
      double x = box.centreX() - origin.centreX();
      double y = box.centreY() - origin.centreY();
      sumX[0] += x;
      sumX[1] += x * t;
      sumY[0] += y;
      sumY[1] += y * t;
    }

    /** Pixels a second, from the sums of positions and of positions times time. */
    double slope(double[] sums) {
      return (n * sums[1] - sumT * sums[0]) / (n * sumTt - sumT * sumT);
    }
  }
}
