package haltere.filters.object;

import java.util.HashMap;
import java.util.Map;

/** A connected region of an object's template, followed through time. */
final class Component {
  static final int PATH = 16;
  final int serial = ++Obj.serials;
  final double[] pathX = new double[PATH];
  final double[] pathY = new double[PATH];
  final Map<Integer, Double> evidence = new HashMap<>();
  int age;
  double x;
  double y;
  double halfX;
  double halfY;
  double mass;
  boolean seen;
  int label;
  int unseen;

  void walk(double absX, double absY) {
    pathX[age % PATH] = absX;
    pathY[age % PATH] = absY;
    age++;
  }

  double displacementX(int n) {
    return pathX[(age - 1) % PATH] - pathX[(age - 1 - n) % PATH];
  }

  double displacementY(int n) {
    return pathY[(age - 1) % PATH] - pathY[(age - 1 - n) % PATH];
  }

  double size() {
    return 2 * Math.max(halfX, halfY);
  }
}
