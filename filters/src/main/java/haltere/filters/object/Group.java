package haltere.filters.object;

import java.util.ArrayList;
import java.util.List;

/** Parts that are one object. */
final class Group {
  final List<Obj> parts = new ArrayList<>();
  final List<double[]> history = new ArrayList<>();
  int id;
  long bornUs;
  long seenUs;
  boolean lost;

  double novelty() {
    double sum = 0;
    for (Obj o : parts) {
      sum += o.novelty;
    }
    return sum;
  }

  double events() {
    double sum = 0;
    for (Obj o : parts) {
      sum += o.events;
    }
    return sum;
  }

  boolean isMoving() {
    for (Obj o : parts) {
      if (o.moving >= 0.5) {
        return true;
      }
    }
    return false;
  }

  double existence() {
    double none = 1;
    for (Obj o : parts) {
      none *= o.gone;
    }
    return 1 - none;
  }

  double weight() {
    double sum = 0;
    for (Obj o : parts) {
      sum += o.rate * Math.max(o.moving, 1e-3);
    }
    return sum;
  }

  double vx() {
    double sum = 0;
    for (Obj o : parts) {
      sum += o.rate * Math.max(o.moving, 1e-3) * o.vx();
    }
    return sum / weight();
  }

  double vy() {
    double sum = 0;
    for (Obj o : parts) {
      sum += o.rate * Math.max(o.moving, 1e-3) * o.vy();
    }
    return sum / weight();
  }

  double lowX;
  double highX;
  double lowY;
  double highY;

  private static final double TAIL = ObjectTracker.p("grouptail", 0.04);

  /** Box of all but the tails of the parts' events, a part being evenly filled. */
  void box() {
    lowX = quantile(TAIL, true);
    highX = quantile(1 - TAIL, true);
    lowY = quantile(TAIL, false);
    highY = quantile(1 - TAIL, false);
  }

  private double quantile(double share, boolean alongX) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (Obj o : parts) {
      double m = alongX ? o.middleX() : o.middleY();
      double h = alongX ? o.shape.halfX : o.shape.halfY;
      low = Math.min(low, m - h);
      high = Math.max(high, m + h);
    }
    if (parts.size() == 1) {
      return share < 0.5 ? low : high;
    }
    for (int k = 0; k < 20; k++) {
      double middle = 0.5 * (low + high);
      double sum = 0;
      double all = 0;
      for (Obj o : parts) {
        double m = alongX ? o.middleX() : o.middleY();
        double h = alongX ? o.shape.halfX : o.shape.halfY;
        double w = o.rate * Math.max(o.moving, 0.05);
        sum += w * Math.max(0, Math.min(1, (middle - m + h) / (2 * h)));
        all += w;
      }
      if (sum < share * all) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return 0.5 * (low + high);
  }

  double size() {
    return Math.max(highX - lowX, highY - lowY);
  }
}
