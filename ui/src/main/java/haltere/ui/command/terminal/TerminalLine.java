package haltere.ui.command.terminal;

import java.io.PrintStream;
import java.util.function.LongSupplier;

/**
 * The last line of a terminal, redrawn at most ten times a second. Silent without a terminal.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
class TerminalLine implements AutoCloseable {
  private static final long REDRAW_NANOS = 100_000_000L;

  private final PrintStream err;
  private final boolean shown;
  private final LongSupplier nanoTime;
  private final long startNanos;
  private long lastDrawNanos;
  private int drawnLength;

  /** A line that has not been drawn; a hidden one is silent. */
  TerminalLine(PrintStream err, boolean shown, LongSupplier nanoTime) {
    this.err = err;
    this.shown = shown;
    this.nanoTime = nanoTime;
    startNanos = nanoTime.getAsLong();
    lastDrawNanos = startNanos;
  }

  /** Time since the line was made, nanoseconds. */
  long elapsedNanos() {
    return nanoTime.getAsLong() - startNanos;
  }

  /** Whether it is time to draw again; if so, the next time is a tenth of a second later. */
  synchronized boolean isDue() {
    long now = nanoTime.getAsLong();
    if (!shown || now - lastDrawNanos < REDRAW_NANOS) {
      return false;
    }
    lastDrawNanos = now;
    return true;
  }

  /** Draws a text in place of the previous one, cut off at the terminal's edge. */
  synchronized void draw(String text) {
    String rest = " ".repeat(Math.max(0, drawnLength - text.length()));
    err.print("\u001b[?7l\r" + text + rest + "\u001b[?7h"); // not wrapped in between
    err.flush();
    drawnLength = text.length();
  }

  /** Takes the line away, so that results can be printed. */
  public synchronized void erase() {
    if (drawnLength > 0) {
      draw("");
      err.print("\r");
      err.flush();
    }
  }

  @Override
  public void close() {
    erase();
  }
}
