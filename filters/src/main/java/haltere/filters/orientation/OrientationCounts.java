package haltere.filters.orientation;

/** A number for each {@link OrientationCount}. */
final class OrientationCounts {
  private final long[] numbers = new long[OrientationCount.values().length];

  void add(OrientationCount what, long number) {
    numbers[what.ordinal()] += number;
  }

  long of(OrientationCount what) {
    return numbers[what.ordinal()];
  }
}
