package haltere.testing.evaluation;

/** Mean and standard deviation of values. Thread rule: that of its owner. */
final class Spread {
  private int count;
  private double sum;
  private double squares;

  void add(double value) {
    count++;
    sum += value;
    squares += value * value;
  }

  int count() {
    return count;
  }

  double mean() {
    return sum / count;
  }

  double sd() {
    return Math.sqrt(Math.max(0, squares / count - mean() * mean()));
  }
}
