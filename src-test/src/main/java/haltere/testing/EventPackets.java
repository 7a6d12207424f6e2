package haltere.testing;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Builders of event streams for tests and benchmarks: the same seed gives the same events. */
public final class EventPackets {
  private EventPackets() {}

  /**
   * Events at random pixels, with random polarities and random steps in time.
   *
   * @param geometry the sensor
   * @param seed of the random numbers
   * @param events how many
   * @param startUs time of the first event
   * @param meanStepUs mean time between two events
   * @return one packet
   */
  public static EventPacket uniform(
      SensorGeometry geometry, long seed, int events, long startUs, double meanStepUs) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket packet = new EventPacket(events);
    double elapsedUs = 0;
    for (int i = 0; i < events; i++) {
      packet.append(
          startUs + (long) elapsedUs,
          EventAddress.pack(
              random.nextInt(geometry.width()),
              random.nextInt(geometry.height()),
              random.nextBoolean()));
      elapsedUs += -meanStepUs * Math.log(1 - random.nextDouble());
    }
    return packet;
  }

  /**
   * What a camera sees of upright bars that move sideways across the whole picture: each pixel that
   * a bar's edge crosses fires one to three times, ON at the leading and OFF at the trailing edge,
   * on top of uniform background activity of 1 Hz a pixel. Neighbours in the picture are neighbours
   * in time, as in real recordings.
   *
   * @param geometry the sensor
   * @param seed of the random numbers
   * @param durationUs length of the stream
   * @param startUs time of its start
   * @return one packet
   */
  public static EventPacket movingBars(
      SensorGeometry geometry, long seed, long durationUs, long startUs) {
    SplittableRandom random = new SplittableRandom(seed);
    EventList events = new EventList();
    int width = geometry.width();
    int height = geometry.height();
    int bars = 4;
    for (int bar = 0; bar < bars; bar++) {
      double pixelsPerUs = width * (1.0 + bar) / 1e6;
      int bottom = bar * height / (bars + 1);
      int top = Math.min(height, bottom + 1 + height / 3);
      boolean on = true;
      for (double crossing = bar * 7 / pixelsPerUs / bars; ; crossing += 1 / pixelsPerUs) {
        if (crossing >= durationUs) {
          break;
        }
        int x = (int) Math.floorMod(Math.round(crossing * pixelsPerUs), (long) width);
        for (int y = bottom; y < top; y++) {
          double timeUs = crossing;
          int repeats = 1 + random.nextInt(3);
          for (int i = 0; i < repeats; i++) {
            timeUs += 20 - 150 * Math.log(1 - random.nextDouble());
            events.add((long) timeUs, x, y, on);
          }
        }
        on = !on;
      }
    }
    addNoise(events, geometry, random, durationUs, 1);
    return events.sorted(startUs, durationUs);
  }

  /**
   * A round blob that moves along a circle around the middle of the sensor, in uniform noise.
   *
   * @param geometry the sensor
   * @param seed of the random numbers
   * @param durationUs length of the stream
   * @param path where the blob is
   * @param eventsPerS events of the blob per second
   * @param noiseHz rate of the noise of each pixel
   * @return one packet that starts at time 0
   */
  public static EventPacket blob(
      SensorGeometry geometry,
      long seed,
      long durationUs,
      BlobPath path,
      double eventsPerS,
      double noiseHz) {
    SplittableRandom random = new SplittableRandom(seed);
    EventList events = new EventList();
    for (double t = 0; ; ) {
      t += -1e6 / eventsPerS * Math.log(1 - random.nextDouble());
      if (t >= durationUs) {
        break;
      }
      double angle = random.nextDouble() * 2 * Math.PI;
      double distance = path.radiusPx() * Math.sqrt(random.nextDouble());
      long x = Math.round(path.x(t) + distance * Math.cos(angle));
      long y = Math.round(path.y(t) + distance * Math.sin(angle));
      if (geometry.contains((int) x, (int) y)) {
        events.add((long) t, (int) x, (int) y, random.nextBoolean());
      }
    }
    addNoise(events, geometry, random, durationUs, noiseHz);
    return events.sorted(0, durationUs);
  }

  /**
   * A circular path.
   *
   * @param centreX middle of the circle
   * @param centreY middle of the circle
   * @param circleRadiusPx how far the blob is from it
   * @param periodUs time of one round
   * @param radiusPx radius of the blob itself
   */
  public record BlobPath(
      double centreX, double centreY, double circleRadiusPx, double periodUs, double radiusPx) {
    /**
     * Column of the blob's centre.
     *
     * @param timeUs microseconds since the start
     * @return x
     */
    public double x(double timeUs) {
      return centreX + circleRadiusPx * Math.cos(2 * Math.PI * timeUs / periodUs);
    }

    /**
     * Row of the blob's centre.
     *
     * @param timeUs microseconds since the start
     * @return y
     */
    public double y(double timeUs) {
      return centreY + circleRadiusPx * Math.sin(2 * Math.PI * timeUs / periodUs);
    }
  }

  /**
   * Adds pixels that fire at a fixed rate whatever happens, as broken ones do.
   *
   * @param packet events, unchanged
   * @param rateHz rate of each of the pixels
   * @param pixels addresses of the pixels
   * @return a new packet
   */
  public static EventPacket withHotPixels(EventPacket packet, double rateHz, int... pixels) {
    EventList events = new EventList();
    for (int i = 0; i < packet.size(); i++) {
      events.add(packet.timeUs(i), packet.x(i), packet.y(i), packet.isOn(i));
    }
    double stepUs = 1e6 / rateHz;
    for (int n = 0; n < pixels.length; n++) {
      double phaseUs = stepUs * n / pixels.length;
      for (double t = packet.firstTimeUs() + phaseUs; t <= packet.lastTimeUs(); t += stepUs) {
        events.add((long) t, EventAddress.x(pixels[n]), EventAddress.y(pixels[n]), true);
      }
    }
    return events.sorted(0, Long.MAX_VALUE);
  }

  private static void addNoise(
      EventList events,
      SensorGeometry geometry,
      SplittableRandom random,
      long durationUs,
      double noiseHz) {
    if (noiseHz <= 0) {
      return;
    }
    double meanStepUs = 1e6 / (noiseHz * geometry.pixels());
    for (double t = 0; ; ) {
      t += -meanStepUs * Math.log(1 - random.nextDouble());
      if (t >= durationUs) {
        return;
      }
      events.add(
          (long) t,
          random.nextInt(geometry.width()),
          random.nextInt(geometry.height()),
          random.nextBoolean());
    }
  }

  /**
   * Cuts a stream into packets at random places; some of the packets are empty, some hold a single
   * event.
   *
   * @param stream events, unchanged
   * @param seed of the random numbers
   * @return new packets that hold the same events in the same order
   */
  public static List<EventPacket> cut(EventPacket stream, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int longest = 1 << random.nextInt(1, 15);
    List<EventPacket> packets = new ArrayList<>();
    int from = 0;
    while (from < stream.size()) {
      int count =
          switch (random.nextInt(8)) {
            case 0 -> 0;
            case 1 -> 1;
            default -> random.nextInt(longest + 1);
          };
      int to = Math.min(stream.size(), from + count);
      packets.add(part(stream, from, to));
      from = to;
    }
    packets.add(new EventPacket(0));
    return packets;
  }

  /**
   * Copies some events of a stream.
   *
   * @param stream events, unchanged
   * @param from index of the first event
   * @param to index after the last event
   * @return a new packet
   */
  public static EventPacket part(EventPacket stream, int from, int to) {
    EventPacket packet = new EventPacket(to - from);
    packet.append(stream, from, to);
    return packet;
  }

  /**
   * Copies a stream.
   *
   * @param stream events, unchanged
   * @return a new packet
   */
  public static EventPacket copy(EventPacket stream) {
    return part(stream, 0, stream.size());
  }

  /**
   * Puts packets one behind the other.
   *
   * @param packets in order
   * @return a new packet of all of their events
   */
  public static EventPacket join(List<EventPacket> packets) {
    EventPacket all = new EventPacket(0);
    for (EventPacket packet : packets) {
      all.append(packet, 0, packet.size());
    }
    return all;
  }

  /**
   * The same events at other times.
   *
   * @param stream events, unchanged
   * @param shiftUs added to each time
   * @return a new packet
   */
  public static EventPacket shifted(EventPacket stream, long shiftUs) {
    EventPacket packet = new EventPacket(stream.size());
    for (int i = 0; i < stream.size(); i++) {
      packet.append(stream.timeUs(i) + shiftUs, stream.address(i));
    }
    return packet;
  }
}
