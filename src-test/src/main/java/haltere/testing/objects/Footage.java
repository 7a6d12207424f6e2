package haltere.testing.objects;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A stretch of events in memory and the truth of its objects.
 *
 * @param geometry of the sensor
 * @param events in ascending time; whoever filters in place takes a copy
 * @param truth in the order of time
 */
record Footage(SensorGeometry geometry, EventPacket events, List<TruthMoment> truth) {
  /** The events and moments of a stretch of time, its end excluded. */
  Footage between(long fromUs, long toUs) {
    int from = events.indexAtOrAfter(fromUs);
    int to = events.indexAtOrAfter(toUs);
    EventPacket part = new EventPacket(to - from);
    part.append(events, from, to);
    return new Footage(
        geometry,
        part,
        truth.stream().filter(m -> m.timeUs() >= fromUs && m.timeUs() < toUs).toList());
  }

  /** Without a share of its events, taken at random. */
  Footage thinned(double share, SplittableRandom random) {
    EventPacket kept = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      if (random.nextDouble() >= share) {
        kept.append(events, i, i + 1);
      }
    }
    return new Footage(geometry, kept, truth);
  }

  /** The same footage at other times. */
  Footage shifted(long shiftUs) {
    return mapped(1, shiftUs);
  }

  /** Backwards from a time on: ON and OFF change places. */
  Footage reversed(long turnUs) {
    return mapped(-1, 2 * turnUs);
  }

  private Footage mapped(int sign, long shiftUs) {
    int n = events.size();
    EventPacket mapped = new EventPacket(n);
    for (int k = 0; k < n; k++) {
      int i = sign > 0 ? k : n - 1 - k;
      int address = events.address(i);
      mapped.append(
          sign * events.timeUs(i) + shiftUs, sign > 0 ? address : address ^ EventAddress.ON_BIT);
    }
    List<TruthMoment> moments = new ArrayList<>();
    for (TruthMoment moment : truth) {
      moments.add(
          sign > 0 ? moments.size() : 0,
          new TruthMoment(sign * moment.timeUs() + shiftUs, moment.objects(), moment.ignored()));
    }
    return new Footage(geometry, mapped, moments);
  }

  /** At another speed: times since the first event are longer by a factor. */
  Footage stretched(double factor) {
    long startUs = events.firstTimeUs();
    EventPacket slower = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      slower.append(stretched(events.timeUs(i), startUs, factor), events.address(i));
    }
    List<TruthMoment> moments = new ArrayList<>();
    for (TruthMoment moment : truth) {
      long timeUs = stretched(moment.timeUs(), startUs, factor);
      moments.add(new TruthMoment(timeUs, moment.objects(), moment.ignored()));
    }
    return new Footage(geometry, slower, moments);
  }

  private static long stretched(long timeUs, long startUs, double factor) {
    return startUs + Math.round((timeUs - startUs) * factor);
  }

  /** With left and right exchanged. */
  Footage mirrored() {
    int lastX = geometry.width() - 1;
    EventPacket mirrored = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      mirrored.append(events.timeUs(i), lastX - events.x(i), events.y(i), events.isOn(i));
    }
    List<TruthMoment> moments = new ArrayList<>();
    for (TruthMoment moment : truth) {
      moments.add(
          new TruthMoment(
              moment.timeUs(),
              moment.objects().stream()
                  .map(one -> new TrueObject(one.id(), one.box().mapped(-1, 1, lastX, 0)))
                  .toList(),
              moment.ignored().stream().map(box -> box.mapped(-1, 1, lastX, 0)).toList()));
    }
    return new Footage(geometry, mirrored, moments);
  }

  /** With events at random times, pixels and polarities between the others. */
  Footage withNoise(double hzPerPixel, SplittableRandom random) {
    EventPacket noisy = new EventPacket(2 * events.size());
    double meanUs = 1e6 / (hzPerPixel * geometry.pixels());
    double nextUs = events.firstTimeUs();
    for (int i = 0; i < events.size(); i++) {
      while (nextUs < events.timeUs(i)) {
        noisy.append(
            (long) nextUs,
            random.nextInt(geometry.width()),
            random.nextInt(geometry.height()),
            random.nextBoolean());
        // intervals of a Poisson process
        nextUs -= meanUs * Math.log(1 - random.nextDouble());
      }
      noisy.append(events, i, i + 1);
    }
    return new Footage(geometry, noisy, truth);
  }

  /** This and then another, which begins no earlier than this ends. */
  Footage then(Footage next) {
    EventPacket all = new EventPacket(events.size() + next.events.size());
    all.append(events, 0, events.size());
    all.append(next.events, 0, next.events.size());
    List<TruthMoment> moments = new ArrayList<>(truth);
    moments.addAll(next.truth);
    return new Footage(geometry, all, moments);
  }
}
