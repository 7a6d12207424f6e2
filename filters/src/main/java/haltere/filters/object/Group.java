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

  /** Box around the parts, those that are present first. */
  void box() {
    lowX = Double.POSITIVE_INFINITY;
    lowY = lowX;
    highX = -lowX;
    highY = -lowX;
    boolean any = false;
    for (int round = 0; round < 2 && !any; round++) {
      for (Obj o : parts) {
        if (round > 0 || o.gone < 0.5) {
          any = true;
          lowX = Math.min(lowX, o.middleX() - o.shape.halfX);
          highX = Math.max(highX, o.middleX() + o.shape.halfX);
          lowY = Math.min(lowY, o.middleY() - o.shape.halfY);
          highY = Math.max(highY, o.middleY() + o.shape.halfY);
        }
      }
    }
  }

  double size() {
    return Math.max(highX - lowX, highY - lowY);
  }
}
