package haltere.core.format;

import haltere.core.event.SampleKind;
import java.util.ArrayList;
import java.util.List;

/**
 * Numbers of frames, inertial samples and triggers.
 *
 * @param frames pictures
 * @param inertialSamples samples of an inertial sensor
 * @param triggers edges and other marks
 * @since 0.1
 */
public record SampleCounts(long frames, long inertialSamples, long triggers) {
  /** None of any kind. */
  public static final SampleCounts NONE = new SampleCounts(0, 0, 0);

  /**
   * The count of a kind.
   *
   * @param kind which one
   * @return at least 0
   */
  public long of(SampleKind kind) {
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
  public SampleCounts plus(SampleKind kind) {
    return new SampleCounts(
        frames + (kind == SampleKind.FRAME ? 1 : 0),
        inertialSamples + (kind == SampleKind.INERTIAL_SAMPLE ? 1 : 0),
        triggers + (kind == SampleKind.TRIGGER ? 1 : 0));
  }

  /**
   * These and others together.
   *
   * @param others what is added
   * @return the sum
   */
  public SampleCounts plus(SampleCounts others) {
    return new SampleCounts(
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
  public SampleCounts minus(SampleCounts others) {
    return new SampleCounts(
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
    for (SampleKind kind : SampleKind.values()) {
      if (of(kind) > 0) {
        parts.add(kind.count(of(kind)));
      }
    }
    return parts.isEmpty() ? "none" : String.join(", ", parts);
  }
}
