package haltere.testing.benchmark;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Why a packet is two arrays: the same filter (keep an event if one of its four neighbours fired in
 * the last 5 ms) on three layouts of the same events, in nanoseconds an event. The filter copies
 * what it keeps to an output, so that all three do the same work.
 *
 * <p>What to look at: two arrays and mutable objects made once are near each other while all is in
 * the cache; a record for each event that is kept costs several times as much, and garbage (add
 * {@code -PjmhArgs='-prof gc'}).
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=PacketLayoutBenchmark}
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PacketLayoutBenchmark {
  private static final int EVENTS = 8192;
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final int STRIDE = SENSOR.width() + 2;
  private static final long NEVER_US = Long.MIN_VALUE / 2;
  private static final long RECENT_US = 5000;

  /** An event as an object of its own that is filled again and again. */
  private static final class MutableEvent {
    long timeUs;
    int x;
    int y;
    boolean on;
  }

  /** An event as a value, made new whenever one is needed. */
  private record EventRecord(long timeUs, int x, int y, boolean on) {}

  private final long[] lastUs = new long[STRIDE * (SENSOR.height() + 2)];
  private final EventPacket packet = new EventPacket(EVENTS);
  private final EventPacket kept = new EventPacket(EVENTS);
  private final MutableEvent[] objects = new MutableEvent[EVENTS];
  private final MutableEvent[] keptObjects = new MutableEvent[EVENTS];
  private final List<EventRecord> records = new ArrayList<>(EVENTS);

  /** Makes the same events in each of the layouts. */
  @Setup
  public void setUp() {
    java.util.Arrays.fill(lastUs, NEVER_US);
    EventPacket bars = EventPackets.movingBars(SENSOR, 1, 1_000_000, 0);
    packet.append(bars, 0, EVENTS);
    for (int i = 0; i < EVENTS; i++) {
      objects[i] = new MutableEvent();
      keptObjects[i] = new MutableEvent();
      objects[i].timeUs = packet.timeUs(i);
      objects[i].x = packet.x(i);
      objects[i].y = packet.y(i);
      objects[i].on = packet.isOn(i);
      records.add(new EventRecord(packet.timeUs(i), packet.x(i), packet.y(i), packet.isOn(i)));
    }
  }

  private boolean supported(int x, int y, long timeUs) {
    int pixel = (y + 1) * STRIDE + x + 1;
    long since = timeUs - RECENT_US;
    lastUs[pixel] = timeUs;
    return lastUs[pixel - 1] >= since
        || lastUs[pixel + 1] >= since
        || lastUs[pixel - STRIDE] >= since
        || lastUs[pixel + STRIDE] >= since;
  }

  /**
   * Haltere's packet: an array of times and an array of addresses.
   *
   * @return events kept
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public int twoArrays() {
    kept.clear();
    for (int i = 0; i < packet.size(); i++) {
      int address = packet.address(i);
      long timeUs = packet.timeUs(i);
      if (supported(EventAddress.x(address), EventAddress.y(address), timeUs)) {
        kept.append(timeUs, address);
      }
    }
    return kept.size();
  }

  /**
   * An array of objects that are made once, the layout of the original.
   *
   * @return events kept
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public int mutableObjects() {
    int size = 0;
    for (MutableEvent event : objects) {
      if (supported(event.x, event.y, event.timeUs)) {
        MutableEvent copy = keptObjects[size++];
        copy.timeUs = event.timeUs;
        copy.x = event.x;
        copy.y = event.y;
        copy.on = event.on;
      }
    }
    return size;
  }

  /**
   * A list of records, a new one for each event that is kept.
   *
   * @return events kept
   */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public int listOfRecords() {
    List<EventRecord> output = new ArrayList<>();
    for (EventRecord event : records) {
      if (supported(event.x(), event.y(), event.timeUs())) {
        output.add(new EventRecord(event.timeUs(), event.x(), event.y(), event.on()));
      }
    }
    return output.size();
  }
}
