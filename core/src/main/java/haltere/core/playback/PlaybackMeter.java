package haltere.core.playback;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.LongSupplier;

/**
 * Measures how fast playback goes, how many events there are and what takes the time: which stage
 * of the chain, or the source.
 *
 * <p>Thread rule: the processing thread only.
 */
final class PlaybackMeter {
  private static final long WINDOW_NANOS = 500_000_000L;
  private static final long FIRST_READING_NANOS = 50_000_000L;
  private static final double RATE_MEMORY_US = 50_000;

  private final FilterChain chain;
  private final SourceCursor source;
  private final LongSupplier nanoTime;
  private boolean windowOpen;
  private long windowNanos;
  private long windowPositionUs;
  private double speed;
  private boolean speedKnown;
  private final Map<ChainStage, Long> busyAtWindow = new IdentityHashMap<>();
  private long sourceBusyAtWindow;
  private String slowest = "";
  private double sourceShare;
  private double rateEvents;
  private double rateUs;

  PlaybackMeter(FilterChain chain, SourceCursor source, LongSupplier nanoTime) {
    this.chain = chain;
    this.source = source;
    this.nanoTime = nanoTime;
  }

  /** Time does not go on from what was before: a pause, a jump, another speed. */
  void restart() {
    windowOpen = false;
    speedKnown = false;
    speed = 0;
  }

  /** The same moment has another position from now on. */
  void shift(long us) {
    windowPositionUs += us;
  }

  /** A slice begins. */
  void sliceBegins(long nanos, long positionUs) {
    if (!windowOpen) {
      windowOpen = true;
      open(nanos, positionUs);
      return;
    }
    long passed = nanos - windowNanos;
    if (passed >= FIRST_READING_NANOS && (!speedKnown || passed >= WINDOW_NANOS)) {
      speed = (positionUs - windowPositionUs) * 1000.0 / passed;
    }
    if (passed >= WINDOW_NANOS) {
      slowest = slowestSinceWindow();
      sourceShare = sourceShareSinceWindow(nanos);
      speedKnown = true;
      open(nanos, positionUs);
    }
  }

  private void open(long nanos, long positionUs) {
    windowNanos = nanos;
    windowPositionUs = positionUs;
    sourceBusyAtWindow = source.busyNanos();
    busyAtWindow.clear();
    for (ChainStage stage : chain.stages()) {
      busyAtWindow.put(stage, stage.timing().busyNanos());
    }
  }

  /** A slice has ended. */
  void sliceEnded(long lengthUs, long events) {
    double kept = Math.exp(-lengthUs / RATE_MEMORY_US);
    rateEvents = rateEvents * kept + events;
    rateUs = rateUs * kept + lengthUs;
  }

  double speed() {
    return speed;
  }

  double eventRateEps() {
    return rateUs == 0 ? 0 : rateEvents / rateUs * 1e6;
  }

  String slowestStage() {
    return speedKnown ? slowest : slowestSinceWindow();
  }

  /** Share of real time that the source takes, 0 to 1; 0 while nothing is measured. */
  double sourceShare() {
    if (!windowOpen) {
      return 0;
    }
    return speedKnown ? sourceShare : sourceShareSinceWindow(nanoTime.getAsLong());
  }

  private double sourceShareSinceWindow(long nanos) {
    long passed = nanos - windowNanos;
    return passed <= 0
        ? 0
        : Math.min(1, (source.busyNanos() - sourceBusyAtWindow) / (double) passed);
  }

  private String slowestSinceWindow() {
    String name = "";
    long most = 0;
    for (ChainStage stage : chain.stages()) {
      long busy = stage.timing().busyNanos() - busyAtWindow.getOrDefault(stage, 0L);
      if (busy > most) {
        most = busy;
        name = stage.name();
      }
    }
    return name;
  }
}
