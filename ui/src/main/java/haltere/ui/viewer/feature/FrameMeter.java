package haltere.ui.viewer.feature;

/** Counts shown pictures and computes their rate. */
final class FrameMeter {
  private static final double SMOOTHING = 0.5;

  private long shown;
  private long lastShown;
  private long readNanos;
  private double perSecond;

  /** Counts a new picture on the screen. */
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
      double now = (shown - lastShown) * 1e9 / (nowNanos - readNanos);
      perSecond += SMOOTHING * (now - perSecond);
    }
    readNanos = nowNanos;
    lastShown = shown;
    return perSecond;
  }
}
