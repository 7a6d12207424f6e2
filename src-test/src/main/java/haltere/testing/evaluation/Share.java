package haltere.testing.evaluation;

/**
 * How many of some squares, each over what was stated, are below a limit. Thread rule: that of its
 * owner.
 */
final class Share {
  private int count;
  private int within;

  /** Takes the square of an error over its variance, and below what it is to be. */
  void add(double square, double limit) {
    count++;
    within += square < limit ? 1 : 0;
  }

  /** How many there are. */
  int count() {
    return count;
  }

  /** Share of those within their 95 %. */
  double within() {
    return (double) within / count;
  }

  /** By how much the share may differ from 0.95 by chance, in 95 % of cases. */
  double chance() {
    return 1.96 * Math.sqrt(0.95 * 0.05 / count);
  }
}
