package haltere.filters.orientation;

/**
 * The guesses of one time, and those of the time before while the new ones are made from them. A
 * fixed number of them is kept and reused.
 */
final class HypothesisSet {
  /** Guesses that are kept from one time to the next. */
  private static final int MOST = 8;

  /** The same, with those that stand for a wide one. */
  private static final int MOST_SPLIT = 20;

  /** Guesses while lines are decided upon. */
  private static final int ROOM = 64;

  /** Probability below which a guess is dropped. */
  private static final double LEAST = 1e-4;

  /** Squared distance in standard deviations below which two guesses are one. */
  private static final double ALIKE = 0.5;

  /** The same, weighed with the share of the smaller one. */
  private static final double ALIKE_BY_SHARE = 0.01;

  private AxisHypothesis[] now = made(ROOM);
  private AxisHypothesis[] before = made(ROOM);
  private int size;
  private int oldSize;
  private double best = Double.NEGATIVE_INFINITY;
  private final AxisDifference difference = new AxisDifference();
  private final double[] shift = new double[4];

  private static AxisHypothesis[] made(int count) {
    AxisHypothesis[] all = new AxisHypothesis[count];
    for (int i = 0; i < count; i++) {
      all[i] = new AxisHypothesis();
    }
    return all;
  }

  int size() {
    return size;
  }

  AxisHypothesis get(int index) {
    return now[index];
  }

  int oldSize() {
    return oldSize;
  }

  AxisHypothesis old(int index) {
    return before[index];
  }

  void clear() {
    size = 0;
    best = Double.NEGATIVE_INFINITY;
  }

  /** The guesses become those of the time before. */
  void startAnew() {
    AxisHypothesis[] were = now;
    now = before;
    before = were;
    oldSize = size;
    clear();
  }

  /** One more, of any content; null if there is no room. */
  AxisHypothesis add() {
    return size < ROOM ? now[size++] : null;
  }

  /** One more that will be kept, in place of the least likely one if need be. */
  AxisHypothesis addKept() {
    if (size >= MOST_SPLIT) {
      size--;
    }
    return add();
  }

  /** Largest logarithm of a weight among the finished ones. */
  double best() {
    return best;
  }

  void finish(AxisHypothesis guess) {
    best = Math.max(best, guess.logWeight);
  }

  /** A guess that is no more pursued. */
  void drop(AxisHypothesis guess) {
    guess.logWeight = Double.NEGATIVE_INFINITY;
  }

  /**
   * Makes probabilities of the logarithms, likeliest first; drops, merges, and keeps a few.
   *
   * @param none weight of the case that no guess is right
   * @return probability of that case
   */
  double settle(double none) {
    double most = none > 0 ? Math.log(none) : Double.NEGATIVE_INFINITY;
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
    while (size > 1 && now[size - 1].weight < LEAST) {
      size--;
    }
    merge();
    sort();
    size = Math.min(size, MOST_SPLIT);
    normalise();
    return unknown;
  }

  /** Makes three of each guess that is too wide, as far as there is room. */
  void split() {
    int count = size;
    for (int i = 0; i < count && size + 2 <= MOST_SPLIT; i++) {
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
   * Takes in a direction that the axis has but for an angle ({@link AxisHypothesis#lean}).
   *
   * @param vague whether heads that are far off it may have come round to the tail
   */
  void lean(double[] direction, double variance, double fresh, boolean vague) {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      if (vague) {
        each.face(direction, variance);
      }
      each.lean(direction, variance, fresh);
      each.weight *= Math.exp(each.logWeight);
    }
    sort();
    normalise();
  }

  /**
   * Takes in the guess that was added last.
   *
   * @param chance its weight
   * @param none weight of the case that no guess is right
   * @param others weight of the others together
   * @return probability that no guess is right
   */
  double include(AxisHypothesis guess, double chance, double none, double others) {
    double known = chance + others;
    guess.weight = 0;
    scale(others / known);
    guess.weight = chance / known;
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
        double share = now[j].weight / (now[i].weight + now[j].weight);
        difference.betweenLines(now[i], now[j]);
        double distance = distance(now[i], now[j]);
        if ((now[i].saccadeShare < 0.5) != (now[j].saccadeShare < 0.5)) {
          continue;
        }
        if (distance < ALIKE || share * distance < ALIKE_BY_SHARE) {
          difference.carryCovariance(now[j]);
          now[i].absorb(difference, share);
          now[i].saccadeShare += share * (now[j].saccadeShare - now[i].saccadeShare);
          now[i].weight += now[j].weight;
          AxisHypothesis gone = now[j];
          System.arraycopy(now, j + 1, now, j, size - j - 1);
          now[--size] = gone;
          j--;
        }
      }
    }
  }

  /** Of the differences by the variances of both, entry by entry. */
  private double distance(AxisHypothesis a, AxisHypothesis b) {
    double sum = 0;
    for (int k = 0; k < 4; k++) {
      double d = difference.d[k];
      sum += d * d / (a.error.covariance(k, k) + b.error.covariance(k, k));
    }
    return sum;
  }

  /** Adds an instant to the way that each guess has come. */
  void record() {
    for (int i = 0; i < size; i++) {
      AxisHypothesis each = now[i];
      each.step = new AxisStep(each.predicted, each.transition.clone(), each.state(), each.step);
    }
  }
}
