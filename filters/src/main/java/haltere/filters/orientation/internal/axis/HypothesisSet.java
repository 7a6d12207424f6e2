package haltere.filters.orientation.internal.axis;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import java.util.Comparator;

/** Hypotheses of one time and of the previous time, in a fixed number of reused objects. */
final class HypothesisSet {
  /** Largest number between two times. */
  static final int MAX_LASTING = 20;

  /** Largest number during an update. */
  private static final int CAPACITY = 64;

  /** Probability below which a hypothesis is dropped. */
  private static final double MIN_WEIGHT = 1e-4;

  /** Squared distance in standard deviations below which two hypotheses are merged. */
  private static final double MERGE_DISTANCE = 0.5;

  /** The same, times the share of the less likely one. */
  private static final double MERGE_DISTANCE_BY_SHARE = 0.01;

  private static final Comparator<AxisHypothesis> LIKELIEST_FIRST =
      (a, b) -> Double.compare(b.weight, a.weight);

  private AxisHypothesis[] now = new AxisHypothesis[CAPACITY];
  private AxisHypothesis[] before = new AxisHypothesis[CAPACITY];
  private int size;

  /** Largest log weight of the decided hypotheses. */
  double best = Double.NEGATIVE_INFINITY;

  private final AxisDifference difference = new AxisDifference();
  private final double[] shift = new double[4];

  HypothesisSet() {
    Arrays.setAll(now, i -> new AxisHypothesis());
    Arrays.setAll(before, i -> new AxisHypothesis());
  }

  int size() {
    return size;
  }

  AxisHypothesis get(int index) {
    return now[index];
  }

  AxisHypothesis old(int index) {
    return before[index];
  }

  void clear() {
    size = 0;
    best = Double.NEGATIVE_INFINITY;
  }

  /** Makes the present hypotheses the previous ones; returns their number. */
  int advance() {
    AxisHypothesis[] latest = now;
    now = before;
    before = latest;
    int count = size;
    clear();
    return count;
  }

  /** Adds a hypothesis with arbitrary content; null if the set is full. */
  AxisHypothesis add() {
    return size < CAPACITY ? now[size++] : null;
  }

  /** Adds a hypothesis that outlasts the step; replaces the least likely one of a full set. */
  AxisHypothesis addLasting() {
    if (size >= MAX_LASTING) {
      size--;
    }
    return add();
  }

  /**
   * Normalises the weights, drops, merges and sorts hypotheses, and limits their number. Takes the
   * weight of the case that no hypothesis is true and returns its probability.
   */
  double settle(double none) {
    double max = Math.log(none);
    for (int i = 0; i < size; i++) {
      max = Math.max(max, now[i].logWeight);
    }
    double sum = 0;
    for (int i = 0; i < size; i++) {
      now[i].weight = Math.exp(now[i].logWeight - max);
      sum += now[i].weight;
    }
    double noneWeight = none > 0 ? Math.exp(Math.log(none) - max) : 0;
    if (!(sum > 0)) {
      now[0].weight = 1e-300;
      sum = 1e-300;
    }
    double unknown = noneWeight / (noneWeight + sum);
    scale(1 / sum);
    sort();
    while (size > 1 && now[size - 1].weight < MIN_WEIGHT) {
      size--;
    }
    merge();
    sort();
    size = Math.min(size, MAX_LASTING);
    normalise();
    return unknown;
  }

  /** Splits each wide hypothesis into three, while the set has room. */
  void split() {
    int count = size;
    for (int i = 0; i < count && size + 2 <= MAX_LASTING; i++) {
      AxisHypothesis middle = now[i];
      if (middle.narrow(shift)) {
        middle.weight *= 0.5;
        for (int side = 0; side < 2; side++) {
          AxisHypothesis beside = add();
          beside.copy(middle);
          beside.weight *= 0.5;
          beside.move(shift);
          for (int k = 0; k < 4; k++) {
            shift[k] = -shift[k];
          }
        }
      }
    }
    sort();
  }

  /**
   * Couples the axis to the flight ({@link AxisHypothesis#coupleToFlight}); vague hypotheses may
   * have exchanged head and tail.
   */
  void coupleToFlight(double[] direction, double variance, double fresh, boolean ambiguous) {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      if (ambiguous) {
        each.face(direction, variance);
      }
      each.coupleToFlight(direction, variance, fresh);
      each.weight *= Math.exp(each.logWeight);
    }
    sort();
    normalise();
  }

  /**
   * Sets the weight of the last added hypothesis, relative to that of no true hypothesis and that
   * of all others. Returns the probability that none is true.
   */
  double include(AxisHypothesis added, double chance, double none, double others) {
    double known = chance + others;
    added.weight = 0;
    scale(others / known);
    added.weight = chance / known;
    merge();
    sort();
    normalise();
    return none / (none + known);
  }

  private void scale(double by) {
    for (int i = 0; i < size; i++) {
      now[i].weight *= by;
    }
  }

  private void normalise() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += now[i].weight;
    }
    scale(1 / sum);
  }

  private void sort() {
    Arrays.sort(now, 0, size, LIKELIEST_FIRST);
  }

  private void merge() {
    for (int i = 0; i < size; i++) {
      for (int j = i + 1; j < size; j++) {
        AxisHypothesis other = now[j];
        double share = other.weight / (now[i].weight + other.weight);
        if (areSimilar(now[i], other, share)) {
          difference.merge(share);
          now[i].saccadeShare += share * (other.saccadeShare - now[i].saccadeShare);
          now[i].weight += other.weight;
          System.arraycopy(now, j + 1, now, j, size - j - 1);
          now[--size] = other;
          j--;
        }
      }
    }
  }

  /** Whether two hypotheses have one mode and are similar, by the variances of each entry. */
  private boolean areSimilar(AxisHypothesis a, AxisHypothesis b, double share) {
    double limit = Math.max(MERGE_DISTANCE, MERGE_DISTANCE_BY_SHARE / share);
    double variance = a.angleVariance() + b.angleVariance();
    double cos = Vectors.dot(a.u, b.u);
    if ((a.saccadeShare < 0.5) != (b.saccadeShare < 0.5) || 1 - cos * cos > limit * variance) {
      return false;
    }
    difference.between(a, b, cos < 0 ? -1 : 1);
    double distance = 0;
    for (int k = 0; k < 4; k++) {
      double d = difference.d[k];
      distance += d * d / (a.error.covariance(k, k) + b.error.covariance(k, k));
    }
    return distance < limit;
  }

  /** Adds a time to the path of each hypothesis. */
  void record() {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      each.step = new AxisStep(each.predicted, each.transition.copy(), each.state(), each.step);
    }
  }
}
