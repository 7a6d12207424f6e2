package haltere.filters.wing.internal.search;

import java.util.Arrays;

/** Divides events into the two sides of a body axis. */
final class SideSplit {
  private static final int ROUNDS = 20;

  /** Class of each event: 0 counterclockwise of the axis, 1 clockwise. */
  private final byte[] classes;

  final StrokeSample sample;
  private final double[] sorted;

  /** A point on the axis, in the middle of the events. */
  double middleX;

  double middleY;

  /** A division of the events of a sample. */
  SideSplit(StrokeSample sample, int capacity) {
    this.sample = sample;
    classes = new byte[capacity];
    sorted = new double[capacity];
  }

  /** Finds the middle for an axis: halfway between the medians of both sides. */
  void along(double axis) {
    double cos = Math.cos(axis);
    double sin = Math.sin(axis);
    int n = project(cos, sin);
    double along = (sorted[n / 20] + sorted[n - 1 - n / 20]) / 2;
    n = project(-sin, cos);
    double across = (sorted[n / 20] + sorted[n - 1 - n / 20]) / 2;
    for (int round = 0; round < ROUNDS; round++) {
      int below = Arrays.binarySearch(sorted, 0, n, across);
      below = below < 0 ? -below - 1 : below;
      if (below == 0 || below == n) {
        break;
      }
      double next = (sorted[below / 2] + sorted[(below + n) / 2]) / 2;
      if (Math.abs(next - across) < 0.05) {
        break;
      }
      across = next;
    }
    middleX = along * cos - across * sin;
    middleY = along * sin + across * cos;
  }

  private int project(double cos, double sin) {
    int n = 0;
    for (int i = 0; i < sample.size; i++) {
      if (sample.supported[i]) {
        sorted[n++] = sample.x[i] * cos + sample.y[i] * sin;
      }
    }
    Arrays.sort(sorted, 0, n);
    return n;
  }

  /** Radius about a point that contains nearly all supported events. */
  double reach(double x, double y) {
    int n = 0;
    for (int i = 0; i < sample.size; i++) {
      if (sample.supported[i]) {
        sorted[n++] = Math.hypot(sample.x[i] - x, sample.y[i] - y);
      }
    }
    Arrays.sort(sorted, 0, n);
    return Math.min(sorted[n * 9 / 10] + 4, sorted[n / 2] * 2);
  }

  void classifyAll(int side) {
    Arrays.fill(classes, 0, sample.size, (byte) side);
  }

  /** Assigns each event to its side of the axis through a point. */
  void classify(double x, double y, double axis) {
    double cos = Math.cos(axis);
    double sin = Math.sin(axis);
    for (int i = 0; i < sample.size; i++) {
      double across = (sample.y[i] - y) * cos - (sample.x[i] - x) * sin;
      classes[i] = (byte) (across > 0 ? 0 : 1);
    }
  }

  boolean isOn(int side, int event) {
    return classes[event] == side;
  }

  int count(int side) {
    int all = 0;
    for (int i = 0; i < sample.size; i++) {
      all += classes[i] == side ? 1 : 0;
    }
    return all;
  }
}
