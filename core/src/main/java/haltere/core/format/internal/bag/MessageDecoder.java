package haltere.core.format.internal.bag;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.format.internal.decoding.StreamDecoder;

/**
 * Common part of the decoders with times relative to a base in the message. Rows count from the top
 * in messages.
 *
 * <p>Thread rule: one thread.
 */
abstract class MessageDecoder implements StreamDecoder {
  static final long NS_PER_US = 1_000;

  final int width;
  final int top;
  final ViolationCounts violations;
  final AscendingTimes times = new AscendingTimes();

  MessageDecoder(SensorGeometry geometry, ViolationCounts violations) {
    width = geometry.width();
    top = geometry.height() - 1;
    this.violations = violations;
  }

  /** Starts the events of a message. */
  abstract void startMessage(EventMessage message);

  /**
   * Appends an event, unless it is outside the sensor.
   *
   * @return false if the clock goes back with it
   */
  final boolean take(EventPacket out, long timeUs, int x, int row, int on, long offset) {
    if (x < 0 || x >= width || row < 0 || row > top) {
      violations.add(Violation.OUTSIDE_SENSOR, offset);
      return true;
    }
    if (times.goesBack(timeUs)) {
      violations.add(StepBack.kind(times), offset);
      return false;
    }
    times.advance(timeUs);
    out.append(timeUs, EventAddress.pack(x, top - row, on));
    return true;
  }

  @Override
  public final EventTimes times() {
    return times;
  }
}
