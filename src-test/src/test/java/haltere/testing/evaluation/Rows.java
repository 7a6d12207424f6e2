package haltere.testing.evaluation;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** Rows on a line, written down shortly; times count in frames of 1 ms. */
final class Rows {
  private final List<ObjectPoint> points = new ArrayList<>();

  /** An object at the same place from one frame to another, both included. */
  Rows add(int id, int first, int last, double x) {
    for (int frame = first; frame <= last; frame++) {
      points.add(new ObjectPoint(1000L * frame, id, x, 0));
    }
    return this;
  }

  Collection<ObjectPoint> points() {
    return points;
  }

  static Frames frames(Rows truth, Rows tracks) {
    return Frames.of(truth.points(), tracks.points());
  }

  /** One object of four frames whose track gets a new identity after two. */
  static Frames brokenTrack() {
    return frames(new Rows().add(1, 0, 3, 50), new Rows().add(1, 0, 1, 50).add(2, 2, 3, 50));
  }

  /** Two objects of ten frames whose tracks change places after six. */
  static Frames swappedTracks() {
    return frames(
        new Rows().add(1, 0, 9, 0).add(2, 0, 9, 100),
        new Rows().add(1, 0, 5, 0).add(2, 0, 5, 100).add(2, 6, 9, 0).add(1, 6, 9, 100));
  }

  /** One object of four frames; its track goes astray in the last one. */
  static Frames outlierTrack() {
    return frames(new Rows().add(1, 0, 3, 0), new Rows().add(7, 0, 2, 0).add(7, 3, 3, 900));
  }

  /**
   * One frame. Objects at 0 and 12, tracks at 8 and 20: the nearest pair is (12, 8), but with it
   * the object at 0 has no track within 9.5 and the track at 20 no object.
   */
  static Frames chain() {
    return frames(
        new Rows().add(1, 0, 0, 0).add(2, 0, 0, 12), new Rows().add(1, 0, 0, 8).add(2, 0, 0, 20));
  }

  /** These rows and some of another list. */
  Rows with(Rows others) {
    Rows both = new Rows();
    both.points.addAll(points);
    both.points.addAll(others.points);
    return both;
  }
}
