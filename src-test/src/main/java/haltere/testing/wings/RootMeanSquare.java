package haltere.testing.wings;

/** Root mean square of the added values. */
final class RootMeanSquare {
  private double squares;
  private long count;

  void add(double value) {
    addSquare(value * value);
  }

  void addSquare(double square) {
    squares += square;
    count++;
  }

  /** NaN if nothing was added. */
  double value() {
    return Math.sqrt(squares / count);
  }

  double degrees() {
    return Math.toDegrees(value());
  }
}
