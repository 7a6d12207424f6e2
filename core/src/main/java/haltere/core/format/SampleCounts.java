package haltere.core.format;

import haltere.core.event.SampleKind;
import java.util.ArrayList;
import java.util.List;

/**
 * Numbers of frames, inertial samples and triggers.
 *
 * @param frames number of frames
 * @param inertialSamples samples of an inertial sensor
 * @param triggers edges and other marks
 * @since 0.1
 */
public record SampleCounts(long frames, long inertialSamples, long triggers) {
  /** No samples. */
  public static final SampleCounts NONE = new SampleCounts(0, 0, 0);

  /**
   * The count of a kind.
   *
   * @param kind the kind
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
   * The counts after another sample.
   *
   * @param kind its kind
   * @return new counts
   */
  public SampleCounts plus(SampleKind kind) {
    return new SampleCounts(
        frames + (kind == SampleKind.FRAME ? 1 : 0),
        inertialSamples + (kind == SampleKind.INERTIAL_SAMPLE ? 1 : 0),
        triggers + (kind == SampleKind.TRIGGER ? 1 : 0));
  }

  /**
   * The sum with other counts.
   *
   * @param others added counts
   * @return the sum
   */
  public SampleCounts plus(SampleCounts others) {
    return new SampleCounts(
        frames + others.frames,
        inertialSamples + others.inertialSamples,
        triggers + others.triggers);
  }

  /**
   * The difference from other counts.
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
   * Whether there are no samples.
   *
   * @return true if all counts are 0
   */
  public boolean isEmpty() {
    return frames == 0 && inertialSamples == 0 && triggers == 0;
  }

  /** Text for users, such as "59 frames, 236 triggers"; counts of 0 are omitted. */
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
