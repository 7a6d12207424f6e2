package haltere.core.format.internal.evt;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.format.internal.decoding.StreamDecoder;

/**
 * Common part of the decoders of EVT words. Rows count from the top in the words and from the
 * bottom in the packets. Words other than pixel events (triggers, inertial samples, monitoring) are
 * counted as {@link Violation#OTHER_DATA}.
 *
 * <p>Thread rule: one thread.
 */
abstract sealed class EvtDecoder implements StreamDecoder
    permits Evt2Decoder, Evt21Decoder, Evt3Decoder {
  /** Maximum columns and rows that EVT words can address. */
  public static final int MAX_SIDE = 2048;

  final int width;
  final int top;
  final ViolationCounts violations;
  final EvtClock clock;

  /** Times of the events. */
  final AscendingTimes times = new AscendingTimes();

  /** Events of the word at the input's position that have already been appended. */
  int handedOver;

  EvtDecoder(SensorGeometry geometry, EvtClock clock, ViolationCounts violations) {
    width = geometry.width();
    top = geometry.height() - 1;
    this.clock = clock;
    this.violations = violations;
  }

  /** Time of the last event since a high part's start, within its 64 us; 64 if it is later. */
  final int lowNow(long startUs) {
    long lastUs = times.lastUs();
    return lastUs <= startUs ? 0 : (int) Math.min(64, lastUs - startUs);
  }

  /** Whether an event at a time must wait for {@link EventTimes#acceptRestart()}. */
  final boolean goesBack(long timeUs, long offset) {
    if (!times.goesBack(timeUs)) {
      return false;
    }
    violations.add(StepBack.kind(times), offset);
    return true;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.wrapping(RecordingClock.Zero.CAMERA_START, clock.turnLengthUs());
  }

  @Override
  public final EventTimes times() {
    return times;
  }

  @Override
  public int stateLongs() {
    return 3;
  }

  /** {@link TriggerWords} uses these values too. */
  @Override
  public void save(long[] state, int at) {
    times.save(state, at);
    state[at + 1] = clock.turnUs();
    state[at + 2] = (long) handedOver << 32 | clock.high() & 0xffffffffL;
  }

  @Override
  public void restore(long[] state, int at) {
    times.restore(state, at);
    clock.restore(state[at + 1], (int) state[at + 2]);
    handedOver = (int) (state[at + 2] >> 32);
  }
}
