package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.testing.objects.LabelledRecording.Playback;
import java.io.IOException;
import java.util.List;
import java.util.SplittableRandom;

/**
 * A stretch of a recording with one object, on a clock from 0, without events far from the object's
 * path.
 *
 * @param events those near the path
 * @param boxes where the object is at each step, null where nobody can tell
 * @param filled the same with the nearest known box instead of null
 * @param movingSteps at how many steps before each one the object is known
 * @param scale size in the smallest composite picture over size in the recording
 */
record CompositeSource(
    EventPacket events, Box[] boxes, Box[] filled, int[] movingSteps, double scale) {
  /** Length of a composite, microseconds. */
  static final long DURATION_US = 6_000_000;

  /** Time between two moments of truth, microseconds. */
  static final long STEP_US = 50_000;

  static final int STEPS = (int) (DURATION_US / STEP_US);

  /** Boxes of two labels no farther apart than this are joined by a line, microseconds. */
  private static final long LONGEST_GAP_US = 120_000;

  /** Of so many stretches the one in which the object is known longest is taken. */
  private static final int DRAWS = 5;

  private record Choice(LabelledRecording recording, double scale, double marginPx) {}

  private static final double WIDE_PX = 16;

  /** For recordings in which another object moves close by. */
  private static final double NARROW_PX = 3;

  private static final List<Choice> CHOICES =
      List.of(
          whole("dvs128-pendulum.aedat", 1, WIDE_PX),
          whole("dvs128-walking-10s.aedat", 1, WIDE_PX),
          whole("dvs128-moving-dark-box.aedat", 1, WIDE_PX),
          whole("dvs128-gesture.aedat4", 1, WIDE_PX),
          whole("dvs128-tmpdiff128-2007.dat", 1, NARROW_PX),
          part("evt3-eventpacket.bag", Playback.BACK_AND_FORTH, 700, 2000, 5, 1 / 3.0, NARROW_PX),
          part("dvxplorer-sample.aedat4", Playback.BACK_AND_FORTH, 0, 470, 13, 0.5, WIDE_PX),
          part("dvs.es", Playback.LOOP, 1, 1000, 7, 0.5, WIDE_PX),
          part("nmnist-sample.bin", Playback.LOOP, 0, 311, 20, 2, WIDE_PX));

  private static Choice whole(String file, double scale, double marginPx) {
    return part(file, Playback.ONCE, 0, Long.MAX_VALUE / 2000, 1, scale, marginPx);
  }

  private static Choice part(
      String file,
      Playback playback,
      long fromMs,
      long toMs,
      int times,
      double scale,
      double marginPx) {
    return new Choice(new LabelledRecording(file, playback, fromMs, toMs, times), scale, marginPx);
  }

  /** Number of available recordings. */
  static int choices() {
    return CHOICES.size();
  }

  /** A random stretch of a recording in which its object is known for long. */
  static CompositeSource of(int choice, SplittableRandom random) throws IOException {
    Choice chosen = CHOICES.get(choice);
    Footage footage = chosen.recording.footage();
    long spareUs =
        Math.max(1, footage.events().lastTimeUs() - footage.events().firstTimeUs() - DURATION_US);
    Box[] boxes = {};
    Footage part = null;
    for (int i = 0; i < DRAWS; i++) {
      long fromUs = footage.events().firstTimeUs() + random.nextLong(spareUs);
      Footage drawn = footage.between(fromUs, fromUs + DURATION_US).shifted(-fromUs);
      Box[] itsBoxes = boxes(drawn.truth());
      if (part == null || known(itsBoxes) > known(boxes)) {
        part = drawn;
        boxes = itsBoxes;
      }
    }
    Box[] filled = filled(boxes);
    int[] moving = new int[STEPS];
    for (int i = 1; i < STEPS; i++) {
      moving[i] = moving[i - 1] + (boxes[i - 1] == null ? 0 : 1);
    }
    return new CompositeSource(
        near(part.events(), filled, chosen.marginPx), boxes, filled, moving, chosen.scale);
  }

  /**
   * Duration of known motion up to a time: an object slides across a picture while it moves, and
   * rests where it rests.
   *
   * @param timeUs from 0 to the duration
   * @return seconds
   */
  double movingS(double timeUs) {
    double steps = timeUs / STEP_US;
    int whole = Math.min(STEPS - 1, (int) steps);
    double part = boxes[whole] == null ? 0 : steps - whole;
    return (movingSteps[whole] + part) * STEP_US * 1e-6;
  }

  private static int known(Box[] boxes) {
    int known = 0;
    for (Box box : boxes) {
      known += box == null ? 0 : 1;
    }
    return known;
  }

  private static Box[] boxes(List<TruthMoment> truth) {
    Box[] boxes = new Box[STEPS];
    int next = 0;
    for (int i = 0; i < STEPS; i++) {
      long timeUs = i * STEP_US;
      while (next < truth.size() && truth.get(next).timeUs() < timeUs) {
        next++;
      }
      if (next > 0 && next < truth.size()) {
        TruthMoment a = truth.get(next - 1);
        TruthMoment b = truth.get(next);
        if (b.timeUs() - a.timeUs() <= LONGEST_GAP_US) {
          double u = (double) (timeUs - a.timeUs()) / (b.timeUs() - a.timeUs());
          boxes[i] = between(a.objects().get(0).box(), b.objects().get(0).box(), u);
        }
      }
    }
    return boxes;
  }

  private static Box between(Box a, Box b, double u) {
    return new Box(
        a.x0() + u * (b.x0() - a.x0()),
        a.y0() + u * (b.y0() - a.y0()),
        a.x1() + u * (b.x1() - a.x1()),
        a.y1() + u * (b.y1() - a.y1()));
  }

  private static Box[] filled(Box[] boxes) {
    Box[] filled = new Box[boxes.length];
    for (int i = 0; i < boxes.length; i++) {
      for (int away = 0; filled[i] == null; away++) {
        filled[i] =
            i >= away && boxes[i - away] != null
                ? boxes[i - away]
                : i + away < boxes.length ? boxes[i + away] : null;
      }
    }
    return filled;
  }

  private static EventPacket near(EventPacket events, Box[] boxes, double marginPx) {
    Box path = boxes[0];
    for (Box box : boxes) {
      path = path.with(box);
    }
    EventPacket near = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      if (path.contains(events.x(i), events.y(i), marginPx)) {
        near.append(events.timeUs(i), events.address(i));
      }
    }
    return near;
  }
}
