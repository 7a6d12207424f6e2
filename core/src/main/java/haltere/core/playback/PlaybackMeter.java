package haltere.core.playback;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import java.util.IdentityHashMap;
import java.util.Map;

/** Measures how fast playback goes, how many events there are and which stage takes the time. */
final class PlaybackMeter {
  private static final long WINDOW_NANOS = 500_000_000L;
  private static final long FIRST_READING_NANOS = 50_000_000L;
  private static final double RATE_MEMORY_US = 50_000;

  private final FilterChain chain;
  private boolean windowOpen;
  private long windowNanos;
  private long windowPositionUs;
  private double speed;
  private boolean speedKnown;
  private final Map<ChainStage, Long> busyAtWindow = new IdentityHashMap<>();
  private String slowest = "";
  private double rateEvents;
  private double rateUs;

  PlaybackMeter(FilterChain chain) {
    this.chain = chain;
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
      speedKnown = true;
      open(nanos, positionUs);
    }
  }

  private void open(long nanos, long positionUs) {
    windowNanos = nanos;
    windowPositionUs = positionUs;
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
