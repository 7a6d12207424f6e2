package haltere.core.camera;

import java.util.Objects;

/**
 * Options of a camera's event stream. Zero selects the camera's default.
 *
 * @param transfers buffers that the camera may fill at a time, 0 to {@value #MAX_BUFFERS}
 * @param bufferBytes size of a buffer, 0 to {@value #MAX_BUFFER_BYTES} bytes; smaller ones come
 *     sooner, larger ones cost less
 * @param waitingBuffers filled buffers that may wait for the consumer, 0 to {@value #MAX_BUFFERS};
 *     beyond them events are lost, counted and reported in the stream
 * @param whenFull which events are lost then
 * @param samples whether frames, inertial samples and triggers are read as well
 * @param reconnect whether the camera continues with a new stream when it is plugged in again
 * @since 0.1
 */
public record CameraOptions(
    int transfers,
    int bufferBytes,
    int waitingBuffers,
    WhenFull whenFull,
    boolean samples,
    boolean reconnect) {
  /** The largest number of buffers of a kind. */
  public static final int MAX_BUFFERS = 4096;

  /** The largest buffer. */
  public static final int MAX_BUFFER_BYTES = 1 << 20;

  /** The default options. */
  public static final CameraOptions DEFAULT =
      new CameraOptions(0, 0, 0, WhenFull.DROP_NEWEST, false, false);

  /** Which events are lost if the consumer is too slow, since a camera cannot wait. */
  public enum WhenFull {
    /** The newest ones; the processed stream stays complete as long as possible. For recordings. */
    DROP_NEWEST,
    /**
     * The oldest ones, and data of a USB camera that have waited for half a second. For low
     * latency.
     */
    DROP_OLDEST
  }

  /** Checks the ranges. */
  public CameraOptions {
    require("transfers", transfers, MAX_BUFFERS);
    require("bytes in a buffer", bufferBytes, MAX_BUFFER_BYTES);
    require("waiting buffers", waitingBuffers, MAX_BUFFERS);
    Objects.requireNonNull(whenFull, "whenFull");
  }

  private static void require(String what, int value, int max) {
    if (value < 0 || value > max) {
      throw new IllegalArgumentException(what + " must be 0 to " + max + ", not " + value);
    }
  }

  /**
   * The same options with other buffers.
   *
   * @param newTransfers buffers that the camera may fill at a time
   * @param newBufferBytes size of a buffer
   * @param newWaitingBuffers filled buffers that may wait for the consumer
   * @return new options
   */
  public CameraOptions withBuffers(int newTransfers, int newBufferBytes, int newWaitingBuffers) {
    return new CameraOptions(
        newTransfers, newBufferBytes, newWaitingBuffers, whenFull, samples, reconnect);
  }

  /**
   * The same options with another rule of loss.
   *
   * @param newWhenFull which events are lost if the consumer is too slow
   * @return new options
   */
  public CameraOptions withWhenFull(WhenFull newWhenFull) {
    return new CameraOptions(
        transfers, bufferBytes, waitingBuffers, newWhenFull, samples, reconnect);
  }

  /**
   * The same options with or without samples.
   *
   * @param newReadings whether frames, inertial samples and triggers are read as well
   * @return new options
   */
  public CameraOptions withSamples(boolean newReadings) {
    return new CameraOptions(
        transfers, bufferBytes, waitingBuffers, whenFull, newReadings, reconnect);
  }

  /**
   * The same options with or without reconnection.
   *
   * @param newReconnect whether it continues when it is plugged in again
   * @return new options
   */
  public CameraOptions withReconnect(boolean newReconnect) {
    return new CameraOptions(
        transfers, bufferBytes, waitingBuffers, whenFull, samples, newReconnect);
  }
}
