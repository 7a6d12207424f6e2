package haltere.filters.wing.internal.stroke;

/**
 * Decides whether a filter is in lock: events at their usual rate, more of them near the wing than
 * by chance, and a possible state of a wing.
 */
final class LockMonitor {
  private static final int MAX_UNLOCKED = 25;
  private static final double MIN_EXCESS = 0.1;
  private static final double SILENT_SHARE = 0.12;
  private static final double RATE_MEMORY_S = 0.5;
  private static final double QUICK_BEATS = 3;
  private static final double MIN_OMEGA = 2 * Math.PI * 30;
  private static final double MAX_OMEGA = 2 * Math.PI * 1000;
  private static final double MIN_AMPLITUDE = 0.12;
  private static final double MAX_AMPLITUDE = 2.2;

  private long counted;
  private double quickRate;
  private double meanRate;
  private double sinceLaunchS;
  private int unlocked;

  /**
   * Update, about once a millisecond.
   *
   * @param dtS since the last time, seconds
   * @param taken events that the filter has used since its launch
   * @param omega angular frequency
   * @param amplitude of the stroke
   * @param excess share of events near the wing beyond chance
   */
  void update(double dtS, long taken, double omega, double amplitude, double excess) {
    double rate = (taken - counted) / dtS;
    counted = taken;
    double quickS = QUICK_BEATS * 2 * Math.PI / Math.max(MIN_OMEGA, omega);
    quickRate += dtS / (dtS + quickS) * (rate - quickRate);
    sinceLaunchS += dtS;
    meanRate += dtS / Math.min(sinceLaunchS, RATE_MEMORY_S) * (rate - meanRate);
    boolean possible =
        omega > MIN_OMEGA
            && omega < MAX_OMEGA
            && amplitude > MIN_AMPLITUDE
            && amplitude < MAX_AMPLITUDE;
    boolean locked = quickRate >= SILENT_SHARE * meanRate && excess >= MIN_EXCESS;
    unlocked = !possible ? unlocked + MAX_UNLOCKED : locked ? 0 : unlocked + 1;
  }

  /** Whether lock was lost for long enough. */
  boolean isLost() {
    return unlocked >= MAX_UNLOCKED;
  }
}
