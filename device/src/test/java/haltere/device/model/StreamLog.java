package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;

/** Consumes a camera and keeps what came, after the grammar of streams has looked at it. */
final class StreamLog implements StreamHandler {
  private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
  private static final long STEP_NANOS = TimeUnit.MILLISECONDS.toNanos(20);

  private final Camera camera;
  private final StreamHandler checked = new StreamGrammar(this);
  private final boolean keepingEvents;
  final List<Object> items = new ArrayList<>();
  final EventPacket all = new EventPacket(1024);
  long events;
  long lost;
  int unknownLosses;

  StreamLog(Camera camera) {
    this(camera, true);
  }

  StreamLog(Camera camera, boolean keepingEvents) {
    this.camera = camera;
    this.keepingEvents = keepingEvents;
  }

  /** Consumes until a condition holds. */
  StreamLog until(BooleanSupplier condition) throws IOException {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new AssertionError("waited in vain; so far came " + this);
      }
      if (camera.await(STEP_NANOS) && !camera.next(checked)) {
        throw new AssertionError("the stream ended; before came " + this);
      }
    }
    return this;
  }

  StreamLog untilEvents(long count) throws IOException {
    return until(() -> events >= count);
  }

  /** Consumes until something of a type has come. */
  <T> T untilA(Class<T> type) throws IOException {
    until(() -> items.stream().anyMatch(type::isInstance));
    return type.cast(items.stream().filter(type::isInstance).findFirst().orElseThrow());
  }

  /** Streams that have ended. */
  long ends() {
    return items.stream().filter(EndOfStream.class::isInstance).count();
  }

  /** Consumes all that is there now, and whether the stream is over. */
  boolean drain() throws IOException {
    while (camera.await(0)) {
      if (!camera.next(checked)) {
        return true;
      }
    }
    return false;
  }

  /** Consumes until the stream is over for good. */
  StreamLog untilOver() throws IOException {
    camera.drainTo(checked);
    return this;
  }

  @Override
  public void packet(EventPacket packet) {
    events += packet.size();
    if (keepingEvents) {
      all.append(packet, 0, packet.size());
    }
  }

  @Override
  public void sample(SensorSample sample) {
    items.add(sample);
  }

  @Override
  public void notified(StreamNotification notification) {
    items.add(notification);
    if (notification instanceof DataLost loss) {
      if (loss.estimatedEvents() < 0) {
        unknownLosses++;
      } else {
        lost += loss.estimatedEvents();
      }
    }
  }

  @Override
  public String toString() {
    return events + " events and " + items + "; " + camera.statistics();
  }
}
