package haltere.ui.plot;

/**
 * The time interval that all lanes show: it follows the newest samples, or stands still while a
 * user inspects the past.
 */
public final class TimeWindow {
  /** Shortest span that can be shown. */
  public static final long MIN_SPAN_US = 1_000;

  /** Longest span that can be shown: a day. */
  public static final long MAX_SPAN_US = 86_400_000_000L;

  private long spanUs = 5_000_000;
  private long endUs;
  private boolean following = true;

  /** Five seconds, following. */
  public TimeWindow() {}

  /** Start of the window, microseconds on the recording's clock. */
  public long fromUs() {
    return endUs - spanUs;
  }

  /** End of the window, microseconds on the recording's clock. */
  public long toUs() {
    return endUs;
  }

  /** How much is shown, microseconds. */
  public long spanUs() {
    return spanUs;
  }

  /** Whether the window follows the newest samples; false while a user inspects the past. */
  public boolean isFollowing() {
    return following;
  }

  /** Starts or stops following the newest samples. */
  public void setFollowing(boolean on) {
    following = on;
  }

  /**
   * Sets the present time, microseconds on the recording's clock; has an effect while following.
   */
  public void advanceTo(long nowUs) {
    if (following) {
      endUs = nowUs;
    }
  }

  /**
   * Zooms (in with a factor below 1) around a share of the window, 0 to 1, within the limits. While
   * following, the end is fixed.
   */
  public void zoom(double factor, double position) {
    long wanted = Math.max(MIN_SPAN_US, Math.min(MAX_SPAN_US, Math.round(spanUs * factor)));
    if (!following) {
      endUs += Math.round((wanted - spanUs) * (1 - position));
    }
    spanUs = wanted;
  }

  /** Shifts the window by microseconds, positive to later times, and stops following. */
  public void scroll(long byUs) {
    following = false;
    endUs += byUs;
  }

  /** The time at a share of the window, 0 to 1. */
  public long timeAt(double position) {
    return fromUs() + Math.round(position * spanUs);
  }

  /** The share of the window at a time, 0 to 1 within it. */
  public double shareOf(long timeUs) {
    return (timeUs - fromUs()) / (double) spanUs;
  }
}
