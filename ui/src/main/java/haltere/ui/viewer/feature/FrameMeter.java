package haltere.ui.viewer.feature;

/** Counts pictures shown and says how many a second that is. */
final class FrameMeter {
  private static final double SMOOTHING = 0.5;

  private long shown;
  private long readShown;
  private long readNanos;
  private double perSecond;

  /** A new picture is on the screen. */
  void shown() {
    shown++;
  }

  /** All pictures so far. */
  long total() {
    return shown;
  }

  /** Pictures a second since the last call, smoothed. */
  double perSecond(long nowNanos) {
    if (readNanos != 0 && nowNanos > readNanos) {
      double now = (shown - readShown) * 1e9 / (nowNanos - readNanos);
      perSecond += SMOOTHING * (now - perSecond);
    }
    readNanos = nowNanos;
    readShown = shown;
    return perSecond;
  }
}
