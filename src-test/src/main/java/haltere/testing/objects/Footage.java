package haltere.testing.objects;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.MemoryRecording;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntUnaryOperator;
import java.util.function.LongUnaryOperator;
import java.util.function.UnaryOperator;

/**
 * A stretch of events in memory and the truth of its objects.
 *
 * @param geometry of the sensor
 * @param events in ascending time; whoever filters in place takes a copy
 * @param truth in the order of time
 */
record Footage(SensorGeometry geometry, EventPacket events, List<TruthMoment> truth) {
  /** As a scene with labelled boxes. */
  ObjectScene scene(String name, String kind) {
    return new ObjectScene(
        name, kind, () -> new MemoryRecording(geometry, events), truth, Matching.BOX);
  }

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
    return mapped(false, timeUs -> timeUs + shiftUs, address -> address, box -> box);
  }

  /** Backwards from a time on: ON and OFF change places. */
  Footage reversed(long turnUs) {
    return mapped(
        true, timeUs -> 2 * turnUs - timeUs, address -> address ^ EventAddress.ON_BIT, box -> box);
  }

  /** At another speed: times since the first event are longer by a factor. */
  Footage stretched(double factor) {
    long startUs = events.firstTimeUs();
    return mapped(
        false,
        timeUs -> startUs + Math.round((timeUs - startUs) * factor),
        address -> address,
        box -> box);
  }

  /** With left and right exchanged. */
  Footage mirrored() {
    int lastX = geometry.width() - 1;
    return mapped(
        false,
        timeUs -> timeUs,
        address ->
            EventAddress.pack(
                lastX - EventAddress.x(address),
                EventAddress.y(address),
                address & EventAddress.ON_BIT),
        box -> box.mapped(-1, 1, lastX, 0));
  }

  /** With other times, addresses and boxes; velocities are then unknown. */
  private Footage mapped(
      boolean isBackwards,
      LongUnaryOperator time,
      IntUnaryOperator address,
      UnaryOperator<Box> box) {
    List<TruthMoment> moments = new ArrayList<>();
    for (TruthMoment moment : truth) {
      moments.add(
          new TruthMoment(
              time.applyAsLong(moment.timeUs()),
              moment.objects().stream()
                  .map(object -> new TrueObject(object.id(), box.apply(object.box())))
                  .toList(),
              moment.ignored().stream().map(box).toList()));
    }
    int n = events.size();
    if (isBackwards) {
      Collections.reverse(moments);
    }
    EventPacket mapped = new EventPacket(n);
    for (int k = 0; k < n; k++) {
      int i = isBackwards ? n - 1 - k : k;
      mapped.append(time.applyAsLong(events.timeUs(i)), address.applyAsInt(events.address(i)));
    }
    return new Footage(geometry, mapped, moments);
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
