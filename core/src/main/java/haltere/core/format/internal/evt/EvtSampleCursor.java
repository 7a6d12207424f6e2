package haltere.core.format.internal.evt;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingFile;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Finds time words and external triggers among EVT words. Inertial samples, which few cameras
 * write, are skipped: their units are not stated.
 *
 * <p>Thread rule: one thread.
 */
final class EvtSampleCursor implements SampleCursor {
  private static final int BUFFER_BYTES = 256 * 1024;
  private static final int TIME_LOW = 6;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;

  /** The encodings. */
  enum Words {
    EVT2(4),
    EVT21(8),
    EVT21_LEGACY(8),
    EVT3(2);

    private final int bytes;

    Words(int bytes) {
      this.bytes = bytes;
    }
  }

  private final RecordingFile file;
  private final Words words;
  private final EvtClock clock;
  private final ByteBuffer buffer =
      ByteBuffer.allocateDirect(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN).limit(0);
  private long offset;
  private long timeUs;
  private Trigger trigger;

  EvtSampleCursor(RecordingFile file, long dataOffset, Words words, long firstTurnUs) {
    this.file = file;
    this.words = words;
    clock = words == Words.EVT3 ? EvtClock.narrow(firstTurnUs) : EvtClock.wide(firstTurnUs);
    offset = dataOffset;
  }

  @Override
  public Step next(long untilOffset) throws IOException {
    trigger = null;
    do {
      int from = buffer.position();
      switch (words) {
        case EVT2 -> narrowWords();
        case EVT3 -> shortWords();
        default -> wideWords(words == Words.EVT21_LEGACY ? 32 : 0);
      }
      offset += buffer.position() - from;
      if (trigger != null) {
        return Step.SAMPLE;
      }
      if (offset >= untilOffset) {
        return Step.NOTHING_YET;
      }
      file.read(buffer, offset);
    } while (buffer.remaining() >= words.bytes);
    return Step.END;
  }

  private void narrowWords() {
    int end = buffer.limit() - 4;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      int word = buffer.getInt(position);
      position += 4;
      switch (word >>> 28) {
        case TIME_HIGH -> clock.take(word & 0xfffffff);
        case EXT_TRIGGER -> take(word >>> 22 & 0x3f, word >>> 8 & 0x1f, word & 1);
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void wideWords(int turned) {
    int end = buffer.limit() - 8;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      long word = Long.rotateLeft(buffer.getLong(position), turned);
      position += 8;
      switch ((int) (word >>> 60)) {
        case TIME_HIGH -> clock.take((int) (word >>> 32) & 0xfffffff);
        case EXT_TRIGGER ->
            take((int) (word >>> 54) & 0x3f, (int) (word >>> 40) & 0x1f, (int) (word >>> 32) & 1);
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void take(int low, int channel, int value) {
    if (clock.high() >= 0) {
      take(clock.startUs() + low, channel, value != 0);
    }
  }

  private void shortWords() {
    int end = buffer.limit() - 2;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      int word = buffer.getShort(position) & 0xffff;
      position += 2;
      switch (word >>> 12) {
        case TIME_LOW -> {
          if (clock.high() >= 0) {
            timeUs = clock.startUs() + (word & 0xfff);
          }
        }
        case TIME_HIGH -> {
          if ((word & 0xfff) != clock.high()) {
            timeUs = clock.take(word & 0xfff);
          }
        }
        case EXT_TRIGGER -> {
          if (clock.high() >= 0) {
            take(timeUs, word >>> 8 & 0xf, (word & 1) != 0);
          }
        }
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void take(long atUs, int channel, boolean rising) {
    Trigger.Edge edge = rising ? Trigger.Edge.RISING : Trigger.Edge.FALLING;
    trigger = new Trigger(atUs, Trigger.Source.EXTERNAL_INPUT, edge, channel);
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  @Override
  public long offset() {
    return offset;
  }

  /** The values are the offset and those of {@link EvtDecoder#save}. */
  @Override
  public void restore(long[] state, int at) {
    offset = state[at];
    buffer.limit(0);
    clock.restore(state[at + 2], (int) state[at + 3]);
    if (words == Words.EVT3) {
      timeUs = state[at + 4];
    }
  }

  @Override
  public void close() {
    buffer.limit(0);
  }
}
