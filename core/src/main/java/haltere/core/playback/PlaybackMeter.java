package haltere.core.playback;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.function.LongSupplier;

/**
 * Measures the speed of playback, the event rate, the slowest stage of the chain and the source's
 * share of the time.
 *
 * <p>Thread rule: the processing thread only.
 */
final class PlaybackMeter {
  private static final long WINDOW_NANOS = 500_000_000L;
  private static final long FIRST_READING_NANOS = 50_000_000L;

  /** Bins over which the event rate is computed, 50 ms; the last may be incomplete. */
  private static final int RATE_BINS = 5;

  private static final long BIN_US = 10_000;

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
  private final long[] binEvents = new long[RATE_BINS];
  private long bin = Long.MIN_VALUE;
  private long firstBin;
  private double eventRateEps;

  PlaybackMeter(FilterChain chain, SourceCursor source, LongSupplier nanoTime) {
    this.chain = chain;
    this.source = source;
    this.nanoTime = nanoTime;
  }

  /** Starts a new measurement of the speed, after a pause, a jump or a change of speed. */
  void restart() {
    windowOpen = false;
    speedKnown = false;
    speed = 0;
  }

  /** Adds to all positions, as when a loop starts again. */
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

  /** Restarts the event rate; the next events do not follow the last ones. */
  void resetRate() {
    bin = Long.MIN_VALUE;
  }

  /** Counts events that are passed on, in slices and run-ups. */
  void handOver(EventPacket piece, long offsetUs) {
    int from = 0;
    while (from < piece.size()) {
      long next = Math.floorDiv(piece.timeUs(from) + offsetUs, BIN_US);
      goTo(next);
      int to = piece.indexAtOrAfter((next + 1) * BIN_US - offsetUs, from);
      binEvents[Math.floorMod(next, RATE_BINS)] += to - from;
      from = to;
    }
  }

  private void goTo(long next) {
    if (bin == Long.MIN_VALUE) {
      firstBin = next;
      bin = next - RATE_BINS;
    }
    for (long passed = Math.max(bin + 1, next - RATE_BINS + 1); passed <= next; passed++) {
      binEvents[Math.floorMod(passed, RATE_BINS)] = 0;
    }
    bin = Math.max(bin, next);
  }

  /** A slice has ended at a position. */
  void sliceEnded(long toUs) {
    if (bin == Long.MIN_VALUE) {
      eventRateEps = 0;
      return;
    }
    goTo(Math.floorDiv(toUs - 1, BIN_US));
    long spanUs = toUs - Math.max(firstBin, bin - RATE_BINS + 1) * BIN_US;
    eventRateEps = spanUs <= 0 ? 0 : Arrays.stream(binEvents).sum() * 1e6 / spanUs;
  }

  double speed() {
    return speed;
  }

  /** Event rate at the end of the last slice, also while a run-up counts other events. */
  double eventRateEps() {
    return eventRateEps;
  }

  String slowestStage() {
    return speedKnown ? slowest : slowestSinceWindow();
  }

  /** Share of real time spent in the source, 0 to 1; 0 without a measurement. */
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
    long maxBusy = 0;
    for (ChainStage stage : chain.stages()) {
      long busy = stage.timing().busyNanos() - busyAtWindow.getOrDefault(stage, 0L);
      if (busy > maxBusy) {
        maxBusy = busy;
        name = stage.name();
      }
    }
    return name;
  }
}
