package haltere.core.format.internal.aedat4;

import haltere.core.event.SensorSample;
import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Set;

/**
 * Goes from packet to packet of an AEDAT-4 file and reads those of frames, inertial samples and
 * triggers. Packets of events are skipped without decompression.
 *
 * <p>Thread rule: one thread.
 */
final class Aedat4SampleCursor implements SampleCursor {
  private static final int TYPE_BYTES = 16;
  private static final int MAX_PAYLOAD = 32 * 1024 * 1024;

  private final Set<Integer> passed;
  private final SamplePayload payload;
  private final ViolationCounts violations;
  private final Decompressor decompressor;
  private final PacketWalk walk;
  private final Queue<SensorSample> found = new ArrayDeque<>();
  private SensorSample sample;

  /**
   * A cursor at the start.
   *
   * @param file the file
   * @param layout layout of its packets
   * @param passed numbers of the skipped streams
   * @param payload converts packets to samples
   * @param violations counts incomplete packets
   */
  Aedat4SampleCursor(
      RecordingFile file,
      Aedat4Cursor.Layout layout,
      Set<Integer> passed,
      SamplePayload payload,
      ViolationCounts violations) {
    this.passed = passed;
    this.payload = payload;
    this.violations = violations;
    decompressor = new Decompressor(file);
    walk = layout.walk(decompressor.window(), new ViolationCounts());
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    while ((sample = found.poll()) == null) {
      if (walk.position() >= untilOffset) {
        return SampleStep.NOTHING_YET;
      }
      if (!walk.find()) {
        return SampleStep.END;
      }
      try {
        if (!passed.contains(walk.stream())) {
          readPacket();
        }
        walk.pass();
      } catch (DamagedPacketException e) {
        violations.add(Violation.INCOMPLETE_SAMPLE, walk.position());
        walk.passDamaged();
      }
    }
    return SampleStep.SAMPLE;
  }

  private void readPacket() throws IOException, DamagedPacketException {
    decompressor.open(walk.payload(), walk.size());
    decompressor.gather(TYPE_BYTES);
    String type = FlatTable.identifier(decompressor.data(), decompressor.from(), decompressor.to());
    if (!SamplePayload.isKnown(type)) {
      return;
    }
    decompressor.gather(MAX_PAYLOAD);
    payload.read(type, decompressor.data(), decompressor.from(), decompressor.to(), found);
  }

  @Override
  public SensorSample sample() {
    return sample;
  }

  @Override
  public long offset() {
    return walk.position();
  }

  @Override
  public void restore(long[] state, int at) {
    walk.moveTo(state[at]);
    found.clear();
  }

  @Override
  public void close() {
    decompressor.close();
  }
}
