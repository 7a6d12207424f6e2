package haltere.ui.plot;

/**
 * Which stretch of time all lanes show: it follows the newest samples, or stands still where a
 * person looks around.
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

  /** Start of what is shown, microseconds on the recording's clock. */
  public long fromUs() {
    return endUs - spanUs;
  }

  /** End of what is shown, microseconds on the recording's clock. */
  public long toUs() {
    return endUs;
  }

  /** How much is shown, microseconds. */
  public long spanUs() {
    return spanUs;
  }

  /** Whether it moves along with time; false while a person looks around. */
  public boolean isFollowing() {
    return following;
  }

  /** Follows, or stands still. */
  public void setFollowing(boolean on) {
    following = on;
  }

  /** Tells where time is, microseconds on the recording's clock; has an effect while following. */
  public void advanceTo(long nowUs) {
    if (following) {
      endUs = nowUs;
    }
  }

  /**
   * Shows more or less (factor below 1) around a place, 0 at the start of the window to 1 at its
   * end, within the limits. While following, the end stays.
   */
  public void zoom(double factor, double position) {
    long wanted = Math.max(MIN_SPAN_US, Math.min(MAX_SPAN_US, Math.round(spanUs * factor)));
    if (!following) {
      endUs += Math.round((wanted - spanUs) * (1 - position));
    }
    spanUs = wanted;
  }

  /** Moves what is shown by microseconds, positive to later times, and stops following. */
  public void scroll(long byUs) {
    following = false;
    endUs += byUs;
  }

  /** The time at a place, 0 at the start of the window to 1 at its end. */
  public long timeAt(double position) {
    return fromUs() + Math.round(position * spanUs);
  }

  /** The place of a time, 0 at the start of the window to 1 at its end, beyond outside of it. */
  public double placeOf(long timeUs) {
    return (timeUs - fromUs()) / (double) spanUs;
  }
}
