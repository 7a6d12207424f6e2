package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTracker;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The wing tracker while it tracks: the time of an event, all edges, from a fly of two million
 * events a second.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 4, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class WingBenchmark {
  private static final int EVENTS = 400_000;

  /** Settings: what is measured against what. */
  @Param({
    "filter.method=EKF",
    "filter.harmonics=1",
    "filter.firstOfRun=false",
    "filter.firstOfRun=false,filter.averagingUs=0",
    "filter.model=EDGES",
    "filter.method=WRA",
    "filter.method=BOTH"
  })
  public String settings;

  private final EventPacket stream = new EventPacket(EVENTS);
  private WingTracker tracker;
  private long lengthUs;

  /** Makes the events and lets the tracker find the fly. */
  @Setup(Level.Trial)
  public void makeEvents() {
    // a whole number of beats, so that the stream can be repeated without a break in the stroke
    FlyScene scene =
        new FlyScene(
            FlySceneSettings.defaults()
                .with(
                    "stroke.beat.frequencyHz=200",
                    "stroke.beat.frequencySdHz=0",
                    "stroke.beat.amplitudeSdRad=0",
                    "fly.body.wobblePx=0",
                    "fly.body.driftPx=0",
                    "fly.wing.visibleShare=0.8",
                    "disturbances.manoeuvres.everyS=0"));
    StreamHandler collect =
        new StreamHandler() {
          @Override
          public void packet(EventPacket part) {
            stream.append(part, 0, part.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            // only events count
          }
        };
    while (stream.size() < EVENTS + 100_000) {
      scene.next(collect);
    }
    lengthUs = (stream.timeUs(EVENTS) / 5000 + 1) * 5000;
    keepEvenly(stream.indexAtOrAfter(lengthUs));
    tracker =
        new WingTracker(
            scene.geometry(),
            WingTrackerSettings.defaults().with(settings.split(",")),
            new WingListener() {
              @Override
              public boolean isRequested(Class<? extends WingResult> kind) {
                return false;
              }

              @Override
              public void accept(WingResult result) {
                // only the time counts
              }
            });
    track();
  }

  /** Of the first events of the stream, which are a few more, as many as are counted. */
  private void keepEvenly(int first) {
    int kept = 0;
    for (int i = 0; i < first; i++) {
      if ((i + 1L) * EVENTS / first > (long) i * EVENTS / first) {
        stream.move(i, kept++);
      }
    }
    stream.truncate(kept);
  }

  private void track() {
    tracker.track(stream);
    // the same events again, later
    long[] times = stream.timesUs();
    int size = stream.size();
    for (int i = 0; i < size; i++) {
      times[i] += lengthUs;
    }
  }

  /**
   * Tracks.
   *
   * @return so that nothing is optimised away
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public double anEvent() {
    track();
    return tracker.meanNis();
  }
}
