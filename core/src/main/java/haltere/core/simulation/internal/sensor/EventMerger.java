package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.simulation.RunSettings;
import java.util.Arrays;

/**
 * Orders the events of pixels into a stream: adds the latency of each event, holds back those of
 * the next interval, sorts by microseconds, and enforces the refractory period of each pixel and
 * the limit of the bus.
 *
 * <p>A latency is never negative, so once all changes before a time have been {@link #add added},
 * all events before that time are complete and can be {@link #release released}. The held events
 * are bounded by one interval and the longest latency.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class EventMerger {
  /** Longest wait for the bus before an event is lost, microseconds. */
  static final double MAX_WAIT_US = 1000;

  private static final long NEVER = Long.MIN_VALUE / 2;

  private final SeededRandom random;
  private double latencyUs;
  private double jitterUs;
  private long refractoryUs;
  private double busSlotUs;
  private final int width;
  private final long startUs;
  private final long endUs;
  private final long[] lastOfPixel;
  private long[] waitingUs = new long[1024];
  private int[] waitingAddress = new int[1024];
  private int waiting;
  private long[] sortedUs = new long[1024];
  private int[] sortedAddress = new int[1024];
  private int[] positions = new int[1025];
  private long releasedUs;
  private double busFreeUs;
  private long lost;

  /**
   * A merger.
   *
   * @param pixel latency, jitter, refractory period and bus
   * @param sensor its size
   * @param run its start, length and seed
   */
  public EventMerger(PixelSettings pixel, SensorSettings sensor, RunSettings run) {
    random = new SeededRandom(run.seed(), "jitter");
    tune(pixel);
    width = sensor.widthPx();
    startUs = run.startUs();
    endUs = run.durationUs().orElse(Long.MAX_VALUE);
    lastOfPixel = new long[width * sensor.heightPx()];
    Arrays.fill(lastOfPixel, NEVER);
  }

  /**
   * Changes latency, jitter, refractory period and bus for later events.
   *
   * @param pixel the new settings
   */
  public void tune(PixelSettings pixel) {
    latencyUs = pixel.latencyUs();
    jitterUs = pixel.jitterUs();
    refractoryUs = (long) Math.floor(pixel.refractoryUs());
    busSlotUs = pixel.busLimitEps() == 0 ? 0 : 1e6 / pixel.busLimitEps();
  }

  /**
   * Adds an event, before its latency.
   *
   * @param changeUs when the level crossed the threshold, microseconds since the beginning
   * @param address as in an event packet
   */
  public void add(double changeUs, int address) {
    double delay = latencyUs;
    if (jitterUs > 0) {
      delay = Math.max(0, delay + jitterUs * random.gaussian());
    }
    if (waiting == waitingUs.length) {
      waitingUs = Arrays.copyOf(waitingUs, waiting * 2);
      waitingAddress = Arrays.copyOf(waitingAddress, waiting * 2);
    }
    waitingUs[waiting] = (long) (changeUs + delay);
    waitingAddress[waiting++] = address;
  }

  /**
   * Events that the bus did not carry.
   *
   * @return so far
   */
  public long lost() {
    return lost;
  }

  /**
   * Releases all events before a time.
   *
   * @param untilUs microseconds since the beginning; no earlier change is added afterwards
   * @param out gets them behind those it has
   */
  public void release(long untilUs, EventPacket out) {
    int span = (int) (untilUs - releasedUs);
    if (positions.length < span + 1) {
      positions = new int[span + 1];
    }
    Arrays.fill(positions, 0, span + 1, 0);
    int due = 0;
    for (int i = 0; i < waiting; i++) {
      long offset = waitingUs[i] - releasedUs;
      if (offset < span) {
        positions[(int) offset + 1]++;
        due++;
      }
    }
    for (int i = 1; i <= span; i++) {
      positions[i] += positions[i - 1];
    }
    if (sortedUs.length < due) {
      sortedUs = new long[waitingUs.length];
      sortedAddress = new int[waitingUs.length];
    }
    int count = 0;
    for (int i = 0; i < waiting; i++) {
      long offset = waitingUs[i] - releasedUs;
      if (offset < span) {
        int position = positions[(int) offset]++;
        sortedUs[position] = waitingUs[i];
        sortedAddress[position] = waitingAddress[i];
      } else {
        waitingUs[count] = waitingUs[i];
        waitingAddress[count++] = waitingAddress[i];
      }
    }
    waiting = count;
    releasedUs = untilUs;
    for (int i = 0; i < due; i++) {
      send(sortedUs[i], sortedAddress[i], out);
    }
  }

  private void send(long timeUs, int address, EventPacket out) {
    int pixel = EventAddress.y(address) * width + EventAddress.x(address);
    if (timeUs - lastOfPixel[pixel] < refractoryUs) {
      return;
    }
    lastOfPixel[pixel] = timeUs;
    long sentUs = timeUs;
    if (busSlotUs > 0) {
      double turnUs = Math.max(timeUs, busFreeUs);
      if (turnUs - timeUs > MAX_WAIT_US) {
        lost++;
        return;
      }
      busFreeUs = turnUs + busSlotUs;
      sentUs = (long) turnUs;
    }
    if (sentUs < endUs) {
      out.append(startUs + sentUs, address);
    }
  }
}
