package haltere.core.event;

import java.util.Objects;

/**
 * A marked time: an edge on one of the camera's inputs, or a step of its own operation.
 *
 * @param timeUs microseconds on the source's clock
 * @param source what was marked
 * @param edge which way it went
 * @param channel number of the input, 0 where there is one only
 * @since 0.1
 */
public record Trigger(long timeUs, Source source, Edge edge, int channel) implements SensorSample {
  /** What a trigger marks. */
  public enum Source {
    /** An input of the camera. */
    EXTERNAL_INPUT,
    /** An output that the camera itself drives. */
    SIGNAL_GENERATOR,
    /** The readout of a frame: begins with {@link Edge#RISING}, ends with {@link Edge#FALLING}. */
    FRAME_READOUT,
    /** The exposure of a frame: begins with {@link Edge#RISING}, ends with {@link Edge#FALLING}. */
    EXPOSURE,
    /** The camera's clock was set to 0. */
    CLOCK_RESET
  }

  /** Which way a signal went. */
  public enum Edge {
    /** Up, or a beginning. */
    RISING,
    /** Down, or an end. */
    FALLING,
    /** Up and down again, or a mark whose direction the recording does not tell. */
    PULSE
  }

  /** Checks that nothing is missing. */
  public Trigger {
    Objects.requireNonNull(source, "source");
    Objects.requireNonNull(edge, "edge");
    if (channel < 0) {
      throw new IllegalArgumentException("channels count from 0, not " + channel);
    }
  }

  @Override
  public SampleKind kind() {
    return SampleKind.TRIGGER;
  }
}
