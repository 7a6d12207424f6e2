package haltere.core.format;

import haltere.core.event.ReadingKind;
import java.util.ArrayList;
import java.util.List;

/**
 * How many frames, inertial samples and triggers there are.
 *
 * @param frames pictures
 * @param inertialSamples samples of an inertial sensor
 * @param triggers edges and other marks
 * @since 0.1
 */
public record ReadingCounts(long frames, long inertialSamples, long triggers) {
  /** None of any kind. */
  public static final ReadingCounts NONE = new ReadingCounts(0, 0, 0);

  /**
   * The count of a kind.
   *
   * @param kind which one
   * @return at least 0
   */
  public long of(ReadingKind kind) {
    return switch (kind) {
      case FRAME -> frames;
      case INERTIAL_SAMPLE -> inertialSamples;
      case TRIGGER -> triggers;
    };
  }

  /**
   * One more.
   *
   * @param kind of which kind
   * @return new counts
   */
  public ReadingCounts plus(ReadingKind kind) {
    return new ReadingCounts(
        frames + (kind == ReadingKind.FRAME ? 1 : 0),
        inertialSamples + (kind == ReadingKind.INERTIAL_SAMPLE ? 1 : 0),
        triggers + (kind == ReadingKind.TRIGGER ? 1 : 0));
  }

  /**
   * These and others together.
   *
   * @param others what is added
   * @return the sum
   */
  public ReadingCounts plus(ReadingCounts others) {
    return new ReadingCounts(
        frames + others.frames,
        inertialSamples + others.inertialSamples,
        triggers + others.triggers);
  }

  /**
   * What is left of these without others that are among them.
   *
   * @param others at most as many of each kind
   * @return the difference
   */
  public ReadingCounts minus(ReadingCounts others) {
    return new ReadingCounts(
        frames - others.frames,
        inertialSamples - others.inertialSamples,
        triggers - others.triggers);
  }

  /**
   * Whether there is none at all.
   *
   * @return true if all counts are 0
   */
  public boolean isEmpty() {
    return frames == 0 && inertialSamples == 0 && triggers == 0;
  }

  /** For a person, such as "59 frames, 236 triggers"; those that are 0 are left out. */
  @Override
  public String toString() {
    List<String> parts = new ArrayList<>();
    for (ReadingKind kind : ReadingKind.values()) {
      if (of(kind) > 0) {
        parts.add(kind.count(of(kind)));
      }
    }
    return parts.isEmpty() ? "none" : String.join(", ", parts);
  }
}
