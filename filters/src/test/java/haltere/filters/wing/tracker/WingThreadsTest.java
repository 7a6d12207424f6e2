package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.SharedWork;
import haltere.core.stream.StreamStarted;
import haltere.filters.wing.WingTrackerSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Results of the wing tracker do not depend on the number of threads. */
@Timeout(120)
class WingThreadsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private final EventPacket events = Flies.events(0.3, "run.seed=7");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "output.rateHz=1000",
        "output.rateHz=330",
        "filter.method=BOTH",
        "filter.method=WRA",
        "filter.model=EDGES"
      })
  void twoThreadsYieldTheResultsOfOneAcrossJumpsAndGaps(String setting) {
    List<String> one = output(1, setting, true, 1);
    assertTrue(one.size() > 500, "rows: " + one.size());
    assertEquals(one, output(2, setting, true, 2));
  }

  @Test
  void estimatesDoNotDependOnSubscribersOfMeasurements() {
    List<String> wanted = output(2, "output.rateHz=1000", true, 3);
    wanted.removeIf(row -> row.startsWith("measurements"));
    assertEquals(wanted, output(2, "output.rateHz=1000", false, 4));
  }

  /**
   * All that is published, in its order, with a jump to the start, a gap, and packets by chance.
   */
  private List<String> output(int threads, String setting, boolean measurements, long seed) {
    List<String> output = new ArrayList<>();
    Random random = new Random(seed);
    try (SharedWork work = new SharedWork(threads);
        FilterChain chain = new FilterChain(SENSOR)) {
      WingTrackerSettings settings = WingTrackerSettings.defaults().with(setting);
      chain.add("wing-tracker", new WingTrackerFilter(SENSOR, settings));
      chain.share(work);
      for (Outlet<?> outlet : chain.outlets()) {
        if (measurements || !outlet.name().equals("measurements")) {
          outlet.subscribe(result -> output.add(outlet.name() + " " + result));
        }
      }
      chain.notified(new StreamStarted(SENSOR, "test"));
      feed(chain, random, 0, events.size() / 2);
      chain.notified(new Reset(Reset.Cause.SEEK, events.timeUs(events.size() / 2), 0));
      feed(chain, random, 0, events.size() / 2);
      long gapUs = events.timeUs(events.size() / 2);
      chain.notified(new DataLost(-1, 10, gapUs, gapUs, "test"));
      feed(chain, random, events.size() / 2, events.size());
      chain.notified(new EndOfStream(events.lastTimeUs()));
    }
    return output;
  }

  private void feed(FilterChain chain, Random random, int from, int to) {
    int next;
    for (int i = from; i < to; i = next) {
      next = Math.min(to, i + 1 + random.nextInt(5000));
      EventPacket packet = new EventPacket(next - i);
      packet.append(events, i, next);
      chain.process(packet);
    }
  }
}
