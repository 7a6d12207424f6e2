package haltere.core.event;

/**
 * Data of a camera beside its polarity events. Samples travel in the stream one by one, between the
 * packets, in order of time; see {@link haltere.core.stream.StreamHandler#sample}.
 *
 * <p>Thread rule: immutable; they may be kept and handed to other threads.
 *
 * @since 0.1
 */
public sealed interface SensorSample permits Frame, InertialSample, Trigger {
  /**
   * Time of the sample in the stream.
   *
   * @return microseconds on the source's clock, the clock of the events; of a frame the start of
   *     its exposure
   */
  long timeUs();

  /**
   * Kind of the sample.
   *
   * @return its kind
   */
  SampleKind kind();
}
