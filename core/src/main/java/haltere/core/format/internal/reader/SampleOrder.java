package haltere.core.format.internal.reader;

import haltere.core.event.Frame;
import haltere.core.event.SensorSample;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.Closeable;
import java.io.IOException;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;

/**
 * Merges the samples of a recording with its events in order of time. In a file they may be
 * displaced: a frame follows the events of its readout, samples of a packet may precede or follow
 * those of another. So it looks ahead, within bounded memory and a bounded part of the file; a
 * sample with a much earlier time belongs after the next restart of the clock.
 *
 * <p>Thread rule: one thread.
 */
final class SampleOrder implements Closeable {
  private static final long LOOK_AHEAD_US = 250_000;
  private static final long FALL_US = 2_000_000;
  private static final long ANY_TIME_US = Long.MAX_VALUE - LOOK_AHEAD_US;

  /** Bytes searched for samples before the first events are returned. */
  private static final long LOOK_AHEAD_BYTES = 16 << 20;

  private static final int MAX_WAITING = 4096;
  private static final long MAX_WAITING_BYTES = 16 << 20;

  private record WaitingSample(SensorSample sample, long offset, int era, long number) {}

  private final SampleCursor cursor;
  private final PriorityQueue<WaitingSample> waiting =
      new PriorityQueue<>(
          Comparator.comparingInt(WaitingSample::era)
              .thenComparingLong(one -> one.sample().timeUs())
              .thenComparingLong(WaitingSample::number));
  private long waitingBytes;
  private boolean atEnd;
  private int era;
  private int newestEra;
  private long newestUs = Long.MIN_VALUE;
  private long newestOffset;
  private long taken;
  private long fromUs = Long.MIN_VALUE;
  private long fromOffset;

  SampleOrder(SampleCursor cursor) {
    this.cursor = cursor;
  }

  /** {@link SampleCursor#remark()}. */
  Optional<String> remark() {
    return cursor.remark();
  }

  /** Whether a sample precedes an event at or after an offset of the file. */
  boolean isDueBefore(long eventUs, long offset) throws IOException {
    lookAhead(eventUs, Long.MAX_VALUE, offset + LOOK_AHEAD_BYTES);
    WaitingSample first = waiting.peek();
    if (first == null) {
      return false;
    }
    if (first.era > era && first.offset <= offset) {
      // the clock of the events did not go back where that of the samples seemed to
      era = first.era;
    }
    return first.era < era || first.era == era && first.sample.timeUs() <= eventUs || isFull();
  }

  /** Whether a sample precedes a restart of the clock at an offset of the file. */
  boolean isDueBeforeRestart(long offset) throws IOException {
    lookAhead(ANY_TIME_US, offset, offset);
    WaitingSample first = waiting.peek();
    return first != null && first.era <= era && first.offset <= offset;
  }

  /** Whether any sample remains. */
  boolean isDueBeforeEnd() throws IOException {
    era = newestEra;
    lookAhead(ANY_TIME_US, Long.MAX_VALUE, Long.MAX_VALUE);
    return !waiting.isEmpty();
  }

  /** Time of the next sample, {@link Long#MAX_VALUE} if it is after a restart. */
  long nextUs() {
    WaitingSample first = waiting.peek();
    return first == null || first.era > era ? Long.MAX_VALUE : first.sample.timeUs();
  }

  SensorSample take() {
    WaitingSample first = waiting.remove();
    waitingBytes -= bytes(first.sample);
    return first.sample;
  }

  /** Continues after a restart of the clock, when all earlier samples have been passed on. */
  void restarted() {
    era++;
    if (newestEra < era) {
      newestEra = era;
      newestUs = Long.MIN_VALUE;
      List<WaitingSample> later = List.copyOf(waiting);
      waiting.clear();
      for (WaitingSample one : later) {
        waiting.add(new WaitingSample(one.sample, one.offset, era, one.number));
        newestUs = Math.max(newestUs, one.sample.timeUs());
      }
    }
  }

  /**
   * Goes to another position.
   *
   * @param state of the events' cursor at or before the requested time
   * @param from the first requested time
   * @param offset samples before it in the file are skipped
   */
  void seek(long[] state, long from, long offset) throws IOException {
    cursor.restore(state, 0);
    waiting.clear();
    waitingBytes = 0;
    atEnd = false;
    era = 0;
    newestEra = 0;
    newestUs = Long.MIN_VALUE;
    newestOffset = 0;
    fromUs = from;
    fromOffset = offset;
  }

  /** Skips samples before a time. */
  void dropBefore(long from) {
    fromUs = from;
  }

  /** Skips all remaining samples. */
  void seekEnd() {
    waiting.clear();
    waitingBytes = 0;
    atEnd = true;
  }

  private boolean isFull() {
    return waiting.size() >= MAX_WAITING || waitingBytes >= MAX_WAITING_BYTES;
  }

  private void lookAhead(long eventUs, long offset, long untilOffset) throws IOException {
    long untilUs = Math.min(eventUs, ANY_TIME_US) + LOOK_AHEAD_US;
    while (!atEnd
        && newestEra <= era
        && newestUs <= untilUs
        && newestOffset <= offset
        && !isFull()) {
      SampleCursor.SampleStep step = cursor.next(untilOffset);
      if (step != SampleCursor.SampleStep.SAMPLE) {
        atEnd = step == SampleCursor.SampleStep.END;
        return;
      }
      SensorSample sample = cursor.sample();
      newestOffset = cursor.offset();
      long timeUs = sample.timeUs();
      if (newestUs != Long.MIN_VALUE && timeUs < newestUs - FALL_US) {
        newestEra++;
        newestUs = timeUs;
      }
      newestUs = Math.max(newestUs, timeUs);
      if (newestEra == 0 && (timeUs < fromUs || cursor.offset() < fromOffset)) {
        continue;
      }
      waiting.add(new WaitingSample(sample, cursor.offset(), newestEra, taken++));
      waitingBytes += bytes(sample);
    }
  }

  private static long bytes(SensorSample sample) {
    return sample instanceof Frame frame ? frame.rows().capacity() : 64;
  }

  @Override
  public void close() throws IOException {
    cursor.close();
  }
}
