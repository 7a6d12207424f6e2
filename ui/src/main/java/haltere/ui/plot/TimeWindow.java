package haltere.ui.plot;

/**
 * Which stretch of time all lanes show: it follows the newest samples, or stands still where a
 * person looks around.
 *
 * <p>Thread rule: one thread.
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

  /**
   * Start of what is shown.
   *
   * @return microseconds on the recording's clock
   */
  public long fromUs() {
    return endUs - spanUs;
  }

  /**
   * End of what is shown.
   *
   * @return microseconds on the recording's clock
   */
  public long toUs() {
    return endUs;
  }

  /**
   * How much is shown.
   *
   * @return microseconds
   */
  public long spanUs() {
    return spanUs;
  }

  /**
   * Whether it moves along with time.
   *
   * @return false while a person looks around
   */
  public boolean isFollowing() {
    return following;
  }

  /**
   * Follows, or stands still.
   *
   * @param on whether to follow
   */
  public void setFollowing(boolean on) {
    following = on;
  }

  /**
   * Tells where time is; has an effect while following.
   *
   * @param nowUs microseconds on the recording's clock
   */
  public void advanceTo(long nowUs) {
    if (following) {
      endUs = nowUs;
    }
  }

  /**
   * Shows more or less around a place, within the limits. While following, the end stays.
   *
   * @param factor below 1 shows less
   * @param place 0 at the start of the window to 1 at its end
   */
  public void zoom(double factor, double place) {
    long wanted = Math.max(MIN_SPAN_US, Math.min(MAX_SPAN_US, Math.round(spanUs * factor)));
    if (!following) {
      endUs += Math.round((wanted - spanUs) * (1 - place));
    }
    spanUs = wanted;
  }

  /**
   * Moves what is shown, and stops following.
   *
   * @param byUs microseconds, positive to later times
   */
  public void scroll(long byUs) {
    following = false;
    endUs += byUs;
  }

  /**
   * The time at a place.
   *
   * @param place 0 at the start of the window to 1 at its end
   * @return microseconds on the recording's clock
   */
  public long timeAt(double place) {
    return fromUs() + Math.round(place * spanUs);
  }

  /**
   * The place of a time.
   *
   * @param timeUs microseconds on the recording's clock
   * @return 0 at the start of the window to 1 at its end, beyond outside of it
   */
  public double placeOf(long timeUs) {
    return (timeUs - fromUs()) / (double) spanUs;
  }
}
