package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;

/**
 * The hypotheses of one time, and those of the time before while the new ones are made from them. A
 * fixed number of them is kept and reused.
 */
final class HypothesisSet {
  /** Largest number that is kept from one time to the next. */
  static final int MAX_SPLIT = 20;

  /** Largest number while lines are decided upon. */
  private static final int ROOM = 64;

  /** Probability below which a hypothesis is dropped. */
  private static final double MIN_WEIGHT = 1e-4;

  /** Squared distance in standard deviations below which two hypotheses are one. */
  private static final double MERGE_DISTANCE = 0.5;

  /** The same, weighed with the share of the smaller one. */
  private static final double MERGE_DISTANCE_BY_SHARE = 0.01;

  private AxisHypothesis[] now = new AxisHypothesis[ROOM];
  private AxisHypothesis[] before = new AxisHypothesis[ROOM];
  private int size;
  private double best = Double.NEGATIVE_INFINITY;
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

  /** Makes the hypotheses those of the time before; returns how many. */
  int advance() {
    AxisHypothesis[] latest = now;
    now = before;
    before = latest;
    int count = size;
    clear();
    return count;
  }

  /** One more, of any content; null if there is no room. */
  AxisHypothesis add() {
    return size < ROOM ? now[size++] : null;
  }

  /** One more that will be kept, in place of the least likely one if need be. */
  AxisHypothesis addKept() {
    if (size >= MAX_SPLIT) {
      size--;
    }
    return add();
  }

  /** Largest logarithm of a weight among the finished ones. */
  double best() {
    return best;
  }

  void finish(AxisHypothesis hypothesis) {
    best = Math.max(best, hypothesis.logWeight);
  }

  /**
   * Makes probabilities of the logarithms, likeliest first; drops, merges, and keeps a few.
   *
   * @param none weight of the case that no hypothesis is right
   * @return probability of that case
   */
  double settle(double none) {
    double most = Math.log(none);
    for (int i = 0; i < size; i++) {
      most = Math.max(most, now[i].logWeight);
    }
    double sum = 0;
    for (int i = 0; i < size; i++) {
      now[i].weight = Math.exp(now[i].logWeight - most);
      sum += now[i].weight;
    }
    double noneWeight = none > 0 ? Math.exp(Math.log(none) - most) : 0;
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
    size = Math.min(size, MAX_SPLIT);
    normalise();
    return unknown;
  }

  /** Makes three of each hypothesis that is too wide, as far as there is room. */
  void split() {
    int count = size;
    for (int i = 0; i < count && size + 2 <= MAX_SPLIT; i++) {
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
   * Couples the axis to the flight ({@link AxisHypothesis#coupleToFlight}).
   *
   * @param vague whether heads that are far off it may have come round to the tail
   */
  void coupleToFlight(double[] direction, double variance, double fresh, boolean vague) {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      if (vague) {
        each.face(direction, variance);
      }
      each.coupleToFlight(direction, variance, fresh);
      each.weight *= Math.exp(each.logWeight);
    }
    sort();
    normalise();
  }

  /**
   * Takes in the hypothesis that was added last.
   *
   * @param chance its weight
   * @param none weight of the case that no hypothesis is right
   * @param others weight of the others together
   * @return probability that none is right
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
    for (int i = 1; i < size; i++) {
      AxisHypothesis each = now[i];
      int k = i;
      for (; k > 0 && now[k - 1].weight < each.weight; k--) {
        now[k] = now[k - 1];
      }
      now[k] = each;
    }
  }

  private void merge() {
    for (int i = 0; i < size; i++) {
      for (int j = i + 1; j < size; j++) {
        AxisHypothesis other = now[j];
        double share = other.weight / (now[i].weight + other.weight);
        if (areAlike(now[i], other, share)) {
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

  /** Whether two hypotheses are of one mode and near by the variances of both, entry by entry. */
  private boolean areAlike(AxisHypothesis a, AxisHypothesis b, double share) {
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

  /** Adds a time to the steps that led to each hypothesis. */
  void record() {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      each.step = new AxisStep(each.predicted, each.transition.copy(), each.state(), each.step);
    }
  }
}
