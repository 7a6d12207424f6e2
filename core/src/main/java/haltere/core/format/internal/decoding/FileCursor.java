package haltere.core.format.internal.decoding;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.EventTimes;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Reads the events of a file with contiguous events.
 *
 * <p>Thread rule: one thread.
 */
public final class FileCursor implements EventCursor {
  /** Size that stays in the cache between reading and decoding. */
  private static final int BUFFER_BYTES = 64 * 1024;

  private final RecordingFile file;
  private final StreamDecoder decoder;
  private final ViolationCounts violations;
  private final ByteBuffer buffer;
  private long offset;
  private boolean fresh;

  /**
   * A cursor at the first event.
   *
   * @param file the file; it is not closed with the cursor
   * @param dataOffset start of the events
   * @param order byte order of the format
   * @param decoder decodes the events
   * @param violations the counts of the decoder
   */
  public FileCursor(
      RecordingFile file,
      long dataOffset,
      ByteOrder order,
      StreamDecoder decoder,
      ViolationCounts violations) {
    this.file = file;
    this.decoder = decoder;
    this.violations = violations;
    long rest = Math.max(64, file.size() - dataOffset);
    buffer = ByteBuffer.allocateDirect((int) Math.min(BUFFER_BYTES, rest)).order(order).limit(0);
    offset = dataOffset;
  }

  @Override
  public Stop read(EventPacket out, int maxEvents) throws IOException {
    int before = out.size();
    int from = buffer.position();
    boolean back = decoder.decode(buffer, offset, out, maxEvents);
    int used = buffer.position() - from;
    offset += used;
    fresh &= used == 0;
    violations.reached(offset);
    if (back) {
      return Stop.CLOCK_WENT_BACK;
    }
    if (out.size() >= maxEvents) {
      return Stop.MORE;
    }
    if (fresh && used == 0 && out.size() == before) {
      return end(out, maxEvents);
    }
    file.read(buffer, offset);
    fresh = true;
    return Stop.MORE;
  }

  /** Handles the last bytes of the file. */
  private Stop end(EventPacket out, int maxEvents) {
    if (buffer.hasRemaining()
        && offset + buffer.remaining() == file.size()
        && decoder.decodeLast(buffer, offset, out, maxEvents)) {
      if (buffer.hasRemaining()) {
        return Stop.CLOCK_WENT_BACK;
      }
      offset = file.size();
      return Stop.MORE;
    }
    if (offset < file.size() || decoder.unfinished()) {
      violations.addOnce(Violation.CUT_OFF, offset);
    }
    return Stop.END;
  }

  @Override
  public RecordingClock clock() {
    return decoder.clock();
  }

  @Override
  public EventTimes times() {
    return decoder.times();
  }

  @Override
  public long positionBytes() {
    return offset;
  }

  @Override
  public int stateLongs() {
    return 1 + decoder.stateLongs();
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = offset;
    decoder.save(state, at + 1);
  }

  @Override
  public void restore(long[] state, int at) {
    offset = state[at];
    decoder.restore(state, at + 1);
    buffer.limit(0);
    fresh = false;
  }

  @Override
  public void close() {
    buffer.limit(0);
  }
}
