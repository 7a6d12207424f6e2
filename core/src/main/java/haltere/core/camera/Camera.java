package haltere.core.camera;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.util.Optional;

/**
 * An open camera: a live source of events. Its stream begins with {@link StreamStarted}; {@link
 * DataLost} marks missing events, with their number and time span; {@link DeviceLost} reports the
 * loss of the camera, and {@link EndOfStream} follows. With {@link CameraOptions#reconnect()} the
 * camera then waits for its return and starts a new stream, a new part of the same session without
 * repeated events.
 *
 * <p>Thread rule: one consumer thread calls {@link #next} and {@link #await}; everything else,
 * facets too, may be called from any thread.
 *
 * @since 0.1
 */
public interface Camera extends EventSource {
  /**
   * Identification of the camera.
   *
   * @return as listed, with the properties known since opening
   */
  CameraInfo info();

  @Override
  default SensorGeometry geometry() {
    return info().geometry();
  }

  /**
   * Passes on the next packet, notification or sample; waits for it without a time limit. {@link
   * #close} ends the wait; the stream is then still completed.
   *
   * @param handler receives it
   * @return false, without a call, after the last {@link EndOfStream}
   * @throws java.io.InterruptedIOException if the thread is interrupted while it waits
   * @throws IOException if the camera cannot be started
   */
  @Override
  boolean next(StreamHandler handler) throws IOException;

  /**
   * Waits for the next packet, notification or sample without taking it.
   *
   * @param nanos longest wait, 0 for none
   * @return true if {@link #next} would return at once
   * @throws java.io.InterruptedIOException if the thread is interrupted while it waits
   * @throws IOException if the camera cannot be started
   */
  boolean await(long nanos) throws IOException;

  /**
   * An optional function of cameras: {@link Biases}, {@link BiasSliders}, {@link TimestampReset},
   * {@link RegionOfInterest}, {@link Configuration}, {@link ArrayReset}, {@link Led}, {@link
   * ClockSync}, {@link EarlyTransfer}.
   *
   * @param facet its interface
   * @param <F> its type
   * @return the facet, the same object at every call, or empty
   */
  <F> Optional<F> facet(Class<F> facet);

  /**
   * Counts of received and lost data.
   *
   * @return a consistent snapshot
   */
  CameraStatistics statistics();

  /**
   * Relation of the camera's clock to this computer's, and so to those of other cameras.
   *
   * @return empty before the first event, or if it is unknown
   */
  Optional<ClockRelation> clockRelation();

  /**
   * Stops the camera and frees its resources. Does not wait for the consumer, which may still read
   * the data received before and {@link EndOfStream}. Returns within seconds in any case; a second
   * call has no effect.
   */
  @Override
  void close();
}
