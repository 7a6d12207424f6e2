package haltere.core.event;

import java.util.Objects;

/**
 * A marked time: an edge on one of the camera's inputs, or a step of its own operation.
 *
 * @param timeUs microseconds on the source's clock
 * @param source of the trigger
 * @param edge direction of the signal
 * @param channel number of the input, 0 if there is only one
 * @since 0.1
 */
public record Trigger(long timeUs, Source source, Edge edge, int channel) implements SensorSample {
  /** Source of a trigger. */
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

  /** Direction of a signal. */
  public enum Edge {
    /** Up, or a beginning. */
    RISING,
    /** Down, or an end. */
    FALLING,
    /** Up and down again, or unknown. */
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
