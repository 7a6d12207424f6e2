package haltere.ui.command.terminal;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraStatistics;
import java.io.PrintStream;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * Status of cameras on one line of a terminal: rate, losses, waiting transfers and latency.
 *
 * <p>Thread rule: one thread shows; the rest may be called from any.
 */
public final class LiveStatus extends TerminalLine {
  /** Longer text than a terminal's line could not be erased. */
  private static final int MAX_LETTERS = 79;

  private final List<Camera> cameras;
  private final long[] eventsBefore;
  private long nanosBefore;

  /** A status of open cameras that has not been shown yet. */
  public LiveStatus(PrintStream err, boolean shown, List<Camera> cameras, LongSupplier nanoTime) {
    super(err, shown, nanoTime);
    this.cameras = List.copyOf(cameras);
    eventsBefore = new long[cameras.size()];
  }

  /** Shows the present status, unless it was shown recently. */
  public void show() {
    if (!isDue()) {
      return;
    }
    long now = elapsedNanos();
    double sinceS = (now - nanosBefore) / 1e9;
    nanosBefore = now;
    StringBuilder text = new StringBuilder();
    long seconds = now / 1_000_000_000L;
    text.append(Quantities.text("%d:%02d", seconds / 60, seconds % 60));
    for (int i = 0; i < cameras.size(); i++) {
      CameraStatistics statistics = cameras.get(i).statistics();
      text.append(i == 0 ? "  " : " | ").append(cameras.get(i).info().id()).append(' ');
      text.append(label(statistics, (statistics.events() - eventsBefore[i]) / sinceS));
      eventsBefore[i] = statistics.events();
    }
    draw(text.substring(0, Math.min(text.length(), MAX_LETTERS)));
  }

  private String label(CameraStatistics statistics, double rate) {
    String longest =
        Quantities.rate(rate) + ", " + Quantities.count(statistics.lostEvents()) + " lost";
    return cameras.size() > 1
        ? longest
        : longest
            + Quantities.text(
                ", %d waiting, median latency %d us",
                statistics.waiting(), statistics.medianLatencyUs());
  }
}
