package haltere.filters.object;

import haltere.filters.estimation.GaussianState;
import java.util.HashMap;
import java.util.Map;

final class Obj {
  static final int PATH = 64;
  static int serials;
  final int serial = ++serials;
  final GaussianState s = new GaussianState(4);
  final ShapeTemplate shape = new ShapeTemplate();
  final Map<Integer, Double> evidence = new HashMap<>();
  final double[] pathX = new double[PATH];
  final double[] pathY = new double[PATH];
  double walkedX;
  double walkedY;
  int age;
  int index;
  long bornUs;
  int bornTick;
  long seenUs;
  Group group;
  double rate;
  double events;
  double moving = 0.9;
  double resting;
  double gone = 0.1;
  // sums of the tick
  double w;
  double gx;
  double gy;
  final double[] logs = new double[3];
  double factor;
  double farthest;
  double novelty;
  double quietS;
  boolean dead;
  double anchorX;
  double anchorY;
  final java.util.List<Component> components = new java.util.ArrayList<>();
  double shownX;
  double shownY;

  double x() {
    return s.mean(0);
  }

  double y() {
    return s.mean(2);
  }

  double vx() {
    return s.mean(1);
  }

  double vy() {
    return s.mean(3);
  }

  double middleX() {
    return x() + shape.middleX;
  }

  double middleY() {
    return y() + shape.middleY;
  }

  double speed() {
    return Math.hypot(vx(), vy());
  }

  double existence() {
    return moving + resting;
  }

  void walk() {
    pathX[age % PATH] = walkedX;
    pathY[age % PATH] = walkedY;
    age++;
    farthest = Math.max(farthest, Math.hypot(walkedX, walkedY));
  }

  /** Displacement over the last ticks. */
  double displacementX(int ticks) {
    int n = Math.min(ticks, age - 1);
    return n <= 0 ? 0 : pathX[(age - 1) % PATH] - pathX[(age - 1 - n) % PATH];
  }

  double displacementY(int ticks) {
    int n = Math.min(ticks, age - 1);
    return n <= 0 ? 0 : pathY[(age - 1) % PATH] - pathY[(age - 1 - n) % PATH];
  }
}
