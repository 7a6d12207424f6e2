package haltere.core.format.internal.evt;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingFile;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Finds the external triggers of a file of EVT words.
 *
 * <p>Thread rule: one thread.
 */
final class EvtSampleCursor implements SampleCursor {
  private static final int BUFFER_BYTES = 256 * 1024;

  private final RecordingFile file;
  private final TriggerWords words;
  private final ByteBuffer buffer =
      ByteBuffer.allocateDirect(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN).limit(0);
  private long offset;
  private Trigger trigger;

  EvtSampleCursor(RecordingFile file, long dataOffset, TriggerWords words) {
    this.file = file;
    this.words = words;
    offset = dataOffset;
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    do {
      int from = buffer.position();
      trigger = words.next(buffer);
      offset += buffer.position() - from;
      if (trigger != null) {
        return SampleStep.SAMPLE;
      }
      if (offset >= untilOffset) {
        return SampleStep.NOTHING_YET;
      }
      file.read(buffer, offset);
    } while (buffer.remaining() >= words.bytes());
    return SampleStep.END;
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  @Override
  public long offset() {
    return offset;
  }

  /** The values are the offset and those of the decoder. */
  @Override
  public void restore(long[] state, int at) {
    offset = state[at];
    buffer.limit(0);
    words.restore(state, at + 1);
  }

  @Override
  public void close() {
    buffer.limit(0);
  }
}
