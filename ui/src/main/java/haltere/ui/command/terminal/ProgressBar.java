package haltere.ui.command.terminal;

import haltere.core.format.ProgressListener;
import java.io.PrintStream;
import java.util.function.LongSupplier;

/**
 * A progress line on a terminal: progress, speed and remaining time. Silent without a terminal;
 * drawn at maxLength ten times a second, erased at the end.
 *
 * <p>Thread rule: one thread.
 */
public final class ProgressBar extends TerminalLine implements ProgressListener {
  private static final int BAR_WIDTH = 24;
  private static final int MIN_BAR_WIDTH = 8;

  /** Letters of label and bar together, so that all fits onto a line of 80. */
  private static final int WIDTH = 46;

  private final String label;
  private final int barWidth;
  private long events = -1;

  /** A bar that has not been drawn; a hidden one is silent. */
  public ProgressBar(PrintStream err, boolean shown, String label, LongSupplier nanoTime) {
    super(err, shown, nanoTime);
    this.label = shortened(label);
    barWidth = Math.min(BAR_WIDTH, WIDTH - this.label.length());
  }

  /** Shortens a long name in its middle, because its end identifies it. */
  private static String shortened(String label) {
    int maxLength = WIDTH - MIN_BAR_WIDTH;
    int tail = maxLength / 2;
    return label.length() <= maxLength
        ? label
        : label.substring(0, maxLength - tail - 1)
            + "\u2026"
            + label.substring(label.length() - tail);
  }

  /** Sets the number of processed events, so that the rate is in events rather than bytes. */
  public void events(long count) {
    events = count;
  }

  @Override
  public void progress(long done, long total) {
    if (isDue()) {
      draw(text(done, total, elapsedNanos() / 1e9));
    }
  }

  private String text(long done, long total, double seconds) {
    double share = total <= 0 ? 0 : Math.min(1, done / (double) total);
    int filled = (int) (share * barWidth);
    StringBuilder bar = new StringBuilder(80);
    bar.append(label).append(" [");
    for (int i = 0; i < barWidth; i++) {
      bar.append(i < filled ? '=' : i == filled ? '>' : ' ');
    }
    bar.append(Quantities.text("] %3d %%", (int) (share * 100)));
    bar.append(
        events >= 0
            ? Quantities.text("  %.1f Mev/s", events / seconds / 1e6)
            : Quantities.text("  %.0f MB/s", done / seconds / 1e6));
    if (share > 0) {
      long left = Math.round(seconds * (1 - share) / share);
      bar.append(Quantities.text("  %d:%02d left", left / 60, left % 60));
    }
    return bar.toString();
  }
}
