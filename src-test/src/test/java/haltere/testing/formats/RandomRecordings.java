package haltere.testing.formats;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Recordings at random and at the edges of what recordings can be, the same at every run. */
final class RandomRecordings {
  private static final long SECOND_US = 1_000_000;
  private static final long HOUR_US = 3600 * SECOND_US;

  /** Every step at which the clock of some format turns, and one more and one less. */
  private static final long[] TURNS_US = {1L << 23, 1L << 24, 1L << 31, 1L << 32};

  private RandomRecordings() {}

  /**
   * A recording.
   *
   * @param name what is special about it
   * @param plain whether every format must hold it
   * @param sensor of the events
   * @param events all of them, in ascending time
   */
  record Recording(String name, boolean plain, SensorGeometry sensor, EventPacket events) {
    @Override
    public String toString() {
      return name + " (" + sensor + ", " + events + ")";
    }
  }

  /** Recordings that every format must hold exactly. */
  static List<Recording> plain() {
    List<Recording> all = new ArrayList<>();
    for (SensorGeometry sensor :
        List.of(
            new SensorGeometry(128, 128, Origin.BOTTOM),
            new SensorGeometry(240, 180, Origin.TOP),
            new SensorGeometry(346, 260, Origin.TOP))) {
      for (long startUs : new long[] {0, 1, SECOND_US + 7}) {
        all.add(plain("a few events", sensor, random(sensor, all.size(), 300, startUs)));
      }
      all.add(plain("no event", sensor, new EventPacket(0)));
      all.add(plain("one event", sensor, random(sensor, 5, 1, 123_456)));
      all.add(plain("corners at one time", sensor, corners(sensor, 4711)));
      all.add(plain("whole rows at one time", sensor, rows(sensor, 12_345)));
      all.add(plain("silences of 20 minutes", sensor, withSilences(sensor, 3, HOUR_US / 3)));
    }
    return all;
  }

  /** Recordings that a format may not be able to hold, which it then has to say. */
  static List<Recording> extreme() {
    List<Recording> all = new ArrayList<>();
    SensorGeometry usual = new SensorGeometry(346, 260, Origin.TOP);
    long sinceEpochUs = 1_718_925_184_590_631L;
    for (long startUs :
        new long[] {
          -1,
          -12_345_678,
          -90 * HOUR_US,
          (1L << 31) - 1000,
          (1L << 32) - 1000,
          (1L << 34) - 1000,
          sinceEpochUs,
          1L << 53,
          1L << 61,
          -(1L << 61),
          Long.MAX_VALUE - SECOND_US,
          -Long.MAX_VALUE
        }) {
      all.add(extreme("from " + startUs + " us", usual, random(usual, startUs, 400, startUs)));
      all.add(extreme("one event", usual, random(usual, startUs, 1, startUs)));
    }
    all.add(extreme("silences of a turn", usual, withSilences(usual, 8, TURNS_US)));
    all.add(
        extreme(
            "silences below zero",
            usual,
            shifted(withSilences(usual, 9, HOUR_US / 2, 12), -HOUR_US / 4)));
    for (int[] size :
        new int[][] {
          {1, 1},
          {2, 1},
          {1, 2},
          {31, 33},
          {640, 480},
          {1280, 720},
          {2048, 2048},
          {2049, 3},
          {3, 2049},
          {16384, 1},
          {32768, 32768}
        }) {
      for (Origin origin : Origin.values()) {
        SensorGeometry sensor = new SensorGeometry(size[0], size[1], origin);
        EventPacket events = corners(sensor, 1000);
        EventPacket more = random(sensor, size[0], 200, 2000);
        events.append(more, 0, more.size());
        all.add(extreme("rows from the " + origin, sensor, events));
      }
    }
    return all;
  }

  private static Recording plain(String name, SensorGeometry sensor, EventPacket events) {
    return new Recording(name, true, sensor, events);
  }

  private static Recording extreme(String name, SensorGeometry sensor, EventPacket events) {
    return new Recording(name, false, sensor, events);
  }

  /** Runs of neighbours, of events at the same time and of single ones, in random order. */
  static EventPacket random(SensorGeometry sensor, long seed, int count, long startUs) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket events = new EventPacket(count);
    long timeUs = startUs;
    while (events.size() < count) {
      int x = random.nextInt(sensor.width());
      int y = random.nextInt(sensor.height());
      boolean on = random.nextBoolean();
      int run = random.nextInt(4) == 0 ? random.nextInt(1, 40) : 1;
      for (int i = 0; i < run && x < sensor.width() && events.size() < count; i++) {
        events.append(timeUs, EventAddress.pack(x, y, on));
        x += random.nextInt(5) == 0 ? 2 : 1;
      }
      timeUs += random.nextInt(3) == 0 ? 0 : random.nextInt(200);
    }
    return events;
  }

  private static EventPacket corners(SensorGeometry sensor, long timeUs) {
    EventPacket events = new EventPacket(16);
    for (int i = 0; i < 16; i++) {
      int x = (i & 1) * (sensor.width() - 1);
      int y = (i >> 1 & 1) * (sensor.height() - 1);
      events.append(timeUs + i / 8, EventAddress.pack(x, y, i >> 2 & 1));
    }
    return events;
  }

  private static EventPacket rows(SensorGeometry sensor, long timeUs) {
    EventPacket events = new EventPacket(0);
    for (int y : new int[] {0, sensor.height() - 1}) {
      for (int x = 0; x < sensor.width(); x++) {
        events.append(timeUs, EventAddress.pack(x, y, y == 0));
      }
      for (int x = sensor.width() - 1; x >= 0; x -= 2) {
        events.append(timeUs, EventAddress.pack(x, y, x % 4 == 0));
      }
    }
    return events;
  }

  /** Events with silences, each of them also a microsecond longer and shorter. */
  private static EventPacket withSilences(SensorGeometry sensor, long seed, long... silencesUs) {
    EventPacket events = new EventPacket(0);
    long timeUs = 1000;
    for (long silenceUs : silencesUs) {
      for (int step = -1; step <= 1; step++) {
        EventPacket part = random(sensor, seed + events.size(), 20, timeUs);
        events.append(part, 0, part.size());
        timeUs = part.lastTimeUs() + silenceUs + step;
      }
    }
    EventPacket last = random(sensor, seed, 20, timeUs);
    events.append(last, 0, last.size());
    return events;
  }

  private static EventPacket shifted(EventPacket events, long shiftUs) {
    for (int i = 0; i < events.size(); i++) {
      events.timesUs()[i] += shiftUs;
    }
    return events;
  }
}
