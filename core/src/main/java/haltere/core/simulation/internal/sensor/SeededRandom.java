package haltere.core.simulation.internal.sensor;

/**
 * The random numbers of a scene: SplitMix64, written out so that a seed gives the same bytes on
 * every machine and in every Java version. Each purpose draws from a stream of its own, so that
 * switching on one part of a scene does not change the others.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class SeededRandom {
  private static final long GOLDEN = 0x9e3779b97f4a7c15L;
  private static final int QUANTILES = 4096;
  private static final double[] GAUSSIAN = gaussianQuantiles();

  private long state;

  /**
   * A stream of numbers.
   *
   * @param seed of the scene
   * @param purpose what the numbers are for
   */
  public SeededRandom(long seed, String purpose) {
    this(mix(mix(seed) ^ purpose.hashCode() * GOLDEN));
  }

  private SeededRandom(long state) {
    this.state = state;
  }

  /**
   * A stream for the n-th item of a purpose, independent of other items, so that items can be drawn
   * in any order.
   *
   * @param seed of the scene
   * @param purpose what the numbers are for
   * @param item which one
   * @return its stream
   */
  public static SeededRandom of(long seed, String purpose, long item) {
    return new SeededRandom(state(seed, purpose, item));
  }

  /**
   * The first 64 bits of the stream of an item, without an object.
   *
   * @param seed of the scene
   * @param purpose what the numbers are for
   * @param item which one
   * @return any number
   */
  public static long firstLong(long seed, String purpose, long item) {
    return mix(state(seed, purpose, item) + GOLDEN);
  }

  /**
   * The first uniformly distributed number of the stream of an item, without an object.
   *
   * @param seed of the scene
   * @param purpose what the numbers are for
   * @param item which one
   * @return at least 0, below 1
   */
  public static double firstDouble(long seed, String purpose, long item) {
    return unit(firstLong(seed, purpose, item));
  }

  private static long state(long seed, String purpose, long item) {
    return mix(mix(mix(seed) ^ purpose.hashCode() * GOLDEN) ^ item * GOLDEN);
  }

  private static long mix(long z) {
    long a = (z ^ (z >>> 30)) * 0xbf58476d1ce4e5b9L;
    long b = (a ^ (a >>> 27)) * 0x94d049bb133111ebL;
    return b ^ (b >>> 31);
  }

  /**
   * All 64 bits.
   *
   * @return any number
   */
  public long nextLong() {
    state += GOLDEN;
    return mix(state);
  }

  /**
   * Evenly spread.
   *
   * @return at least 0, below 1
   */
  public double nextDouble() {
    return unit(nextLong());
  }

  private static double unit(long bits) {
    return (bits >>> 11) * 0x1.0p-53;
  }

  /**
   * Evenly spread.
   *
   * @param min the least
   * @param max never reached
   * @return at least min, below max
   */
  public double between(double min, double max) {
    return min + (max - min) * nextDouble();
  }

  /**
   * Uniformly distributed whole numbers.
   *
   * @param bound never reached, above 0
   * @return 0 to bound - 1
   */
  public int below(int bound) {
    return (int) (((nextLong() >>> 32) * bound) >>> 32);
  }

  /**
   * Waiting time of a Poisson process.
   *
   * @return at least 0, of mean 1
   */
  public double exponential() {
    return -Exponential.log(1 - nextDouble());
  }

  /**
   * Normally distributed.
   *
   * @return of mean 0 and standard deviation 1, never beyond 4
   */
  public double gaussian() {
    double place = nextDouble() * QUANTILES;
    int below = (int) place;
    double low = GAUSSIAN[below];
    return low + (place - below) * (GAUSSIAN[below + 1] - low);
  }

  /** Quantiles of the normal distribution between -4 and 4, scaled to standard deviation 1. */
  private static double[] gaussianQuantiles() {
    int fine = 80_000;
    double[] cumulative = new double[fine + 1];
    for (int i = 1; i <= fine; i++) {
      double z = -4 + 8.0 * (i - 0.5) / fine;
      cumulative[i] = cumulative[i - 1] + StrictMath.exp(-z * z / 2);
    }
    double[] quantiles = new double[QUANTILES + 1];
    int at = 0;
    for (int q = 0; q <= QUANTILES; q++) {
      double wanted = cumulative[fine] * q / QUANTILES;
      while (at < fine && cumulative[at + 1] < wanted) {
        at++;
      }
      quantiles[q] = at == fine ? 4 : -4 + 8.0 * at / fine;
    }
    double square = 0;
    for (int q = 0; q < QUANTILES; q++) {
      double low = quantiles[q];
      double high = quantiles[q + 1];
      square += (low * low + low * high + high * high) / 3 / QUANTILES;
    }
    double scale = 1 / StrictMath.sqrt(square);
    for (int q = 0; q <= QUANTILES; q++) {
      quantiles[q] *= scale;
    }
    return quantiles;
  }
}
