package haltere.core.format.internal.aedat2;

import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingFile;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.WrappingClock;
import haltere.core.format.internal.decoding.SampleCursor;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/**
 * Finds the samples among the records of an AEDAT-1.0 or AEDAT-2.0 file. Events advance its clock,
 * as they do that of {@link RecordDecoder}.
 *
 * <p>Thread rule: one thread.
 */
final class AedatSampleCursor implements SampleCursor {
  private static final int BUFFER_BYTES = 256 * 1024;

  private final RecordingFile file;
  private final int recordBytes;
  private final AddressDecoder addresses;
  private final SampleAssembly assembly;
  private final WrappingClock clock;
  private final Optional<String> rangeRemark;
  private final ByteBuffer buffer =
      ByteBuffer.allocateDirect(BUFFER_BYTES / 24 * 24).order(ByteOrder.BIG_ENDIAN).limit(0);
  private long offset;
  private SensorSample sample;
  private boolean hasInertialSamples;

  /** Assembles samples from the words that are not events. */
  interface SampleAssembly {
    /**
     * Takes the next word.
     *
     * @param word address word of a record
     * @param timeUs its time
     * @param offset byte offset of the record
     * @return the sample that it completes, or null
     */
    SensorSample take(int word, long timeUs, long offset);

    /** Drops incomplete samples. */
    void reset();
  }

  AedatSampleCursor(
      RecordingFile file,
      long dataOffset,
      int recordBytes,
      AedatSensor sensor,
      long firstTurnUs,
      InertialRange range,
      Optional<String> rangeRemark,
      ViolationCounts violations) {
    this.file = file;
    this.recordBytes = recordBytes;
    this.rangeRemark = rangeRemark;
    addresses = sensor.decoder();
    assembly =
        sensor.layout() == AedatSensor.AddressLayout.DVS128
            ? new Dvs128Samples()
            : new DavisSamples(sensor.geometry(), range, violations);
    clock = new WrappingClock(1L << 32, firstTurnUs);
    offset = dataOffset;
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    while (true) {
      while (buffer.remaining() >= recordBytes) {
        int at = buffer.position();
        int word = recordBytes == 8 ? buffer.getInt(at) : buffer.getShort(at) & 0xffff;
        int time = buffer.getInt(at + recordBytes - 4);
        buffer.position(at + recordBytes);
        offset += recordBytes;
        int address = addresses.address(word);
        if (address >= 0) {
          tick(time);
        } else if (address == AddressDecoder.OTHER) {
          sample = assembly.take(word, clock.read(time), offset - recordBytes);
          if (sample != null) {
            hasInertialSamples |= sample instanceof InertialSample;
            return SampleStep.SAMPLE;
          }
        }
      }
      if (offset >= untilOffset) {
        return SampleStep.NOTHING_YET;
      }
      file.read(buffer, offset);
      if (buffer.remaining() < recordBytes) {
        return SampleStep.END;
      }
    }
  }

  private void tick(int time) {
    long timeUs = clock.read(time);
    boolean back = clock.goesBack(timeUs);
    clock.take(timeUs);
    if (back) {
      assembly.reset();
    }
  }

  @Override
  public SensorSample sample() {
    return sample;
  }

  @Override
  public Optional<String> remark() {
    return hasInertialSamples ? rangeRemark : Optional.empty();
  }

  @Override
  public long offset() {
    return offset;
  }

  @Override
  public void restore(long[] state, int at) {
    offset = state[at];
    buffer.limit(0);
    assembly.reset();
    if (state[at + 2] == StreamNotification.NO_TIME_US) {
      clock.reset(state[at + 1]);
    } else {
      clock.resume(state[at + 1], state[at + 2]);
    }
  }

  @Override
  public void close() {
    buffer.limit(0);
  }
}
