package haltere.core.format.internal.aedat3;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingFile;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Goes from packet to packet of an AEDAT-3 file and reads those of special events, frames and
 * inertial samples. After an invalid header it searches the next one, as {@link Aedat3Decoder}
 * does.
 *
 * <p>Thread rule: one thread.
 */
final class Aedat3SampleCursor implements SampleCursor {
  private static final int SEARCH_BYTES = 64 * 1024;
  private static final int FRAME_HEADER = 36;
  private static final int MAX_FRAME_BYTES = 32 * 1024 * 1024;
  private static final int TIME_BITS = 31;

  private final RecordingFile file;
  private final SensorGeometry geometry;
  private final ViolationCounts violations;
  private long position;
  private PacketHeader packet;
  private int event;
  private SensorSample sample;

  Aedat3SampleCursor(
      RecordingFile file, long dataOffset, SensorGeometry geometry, ViolationCounts violations) {
    this.file = file;
    this.geometry = geometry;
    this.violations = violations;
    position = dataOffset;
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    sample = null;
    while (sample == null) {
      if (packet != null && event < packet.number()) {
        readEvent();
        event++;
      } else {
        if (packet != null) {
          position += PacketHeader.BYTES + packet.payloadBytes();
        }
        packet = nextPacket(untilOffset);
        event = 0;
        if (packet == null) {
          return position >= untilOffset ? SampleStep.NOTHING_YET : SampleStep.END;
        }
      }
    }
    return SampleStep.SAMPLE;
  }

  /** The next packet of samples; null at the end or after an offset. */
  private PacketHeader nextPacket(long untilOffset) throws IOException {
    while (position <= file.size() - PacketHeader.BYTES && position < untilOffset) {
      ByteBuffer bytes = bytes(position, PacketHeader.BYTES);
      if (bytes.limit() < PacketHeader.BYTES) {
        return null;
      }
      PacketHeader header = PacketHeader.read(bytes, 0);
      if (!header.isPossible()) {
        search();
        continue;
      }
      if (holdsSamples(header)) {
        return header;
      }
      position += PacketHeader.BYTES + header.payloadBytes();
    }
    return null;
  }

  private static boolean holdsSamples(PacketHeader header) {
    return switch (header.kind()) {
      case PacketHeader.SPECIAL -> header.eventBytes() == 8;
      case PacketHeader.FRAME -> header.eventBytes() > FRAME_HEADER;
      case PacketHeader.INERTIAL_6 -> header.eventBytes() == 36;
      case PacketHeader.INERTIAL_9 -> header.eventBytes() == 48;
      default -> false;
    };
  }

  private void search() throws IOException {
    for (position++; position < file.size(); position += SEARCH_BYTES) {
      ByteBuffer bytes = bytes(position, SEARCH_BYTES + PacketHeader.BYTES);
      int last = Math.min(SEARCH_BYTES - 1, bytes.limit() - PacketHeader.BYTES);
      for (int i = 0; i <= last; i++) {
        long left = file.size() - position - i - PacketHeader.BYTES;
        if (PacketHeader.read(bytes, i).canFollowDamage(left)) {
          position += i;
          return;
        }
      }
    }
  }

  private ByteBuffer bytes(long offset, int count) throws IOException {
    return ByteBuffer.wrap(file.read(offset, count)).order(ByteOrder.LITTLE_ENDIAN);
  }

  private void readEvent() throws IOException {
    long at = position + PacketHeader.BYTES + event * packet.eventBytes();
    int size = (int) Math.min(packet.eventBytes(), FRAME_HEADER + MAX_FRAME_BYTES);
    ByteBuffer bytes = bytes(at, size);
    if (bytes.limit() < size) {
      violations.addOnce(Violation.INCOMPLETE_SAMPLE, at);
      event = packet.number();
      return;
    }
    if ((bytes.getInt(0) & 1) == 0) {
      return;
    }
    sample =
        switch (packet.kind()) {
          case PacketHeader.SPECIAL -> trigger(bytes);
          case PacketHeader.FRAME -> frame(bytes, at);
          default -> inertial(bytes);
        };
  }

  private long time(ByteBuffer bytes, int at) {
    return ((long) packet.overflow() << TIME_BITS) + (bytes.getInt(at) & Integer.MAX_VALUE);
  }

  /** Null for marks of clock wraps and of rows without events. */
  private Trigger trigger(ByteBuffer bytes) {
    long timeUs = time(bytes, 4);
    int type = bytes.getInt(0) >>> 1 & 0x7f;
    return switch (type) {
      case 1 -> new Trigger(timeUs, Trigger.Source.CLOCK_RESET, Trigger.Edge.PULSE, 0);
      case 2, 3, 4 -> new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge(type - 2), 0);
      case 6, 7, 8 -> new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge(type - 6), 1);
      case 9, 10, 11 -> new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge(type - 9), 2);
      case 12, 13 -> new Trigger(timeUs, Trigger.Source.SIGNAL_GENERATOR, edge(type - 12), 0);
      case 14, 15 -> new Trigger(timeUs, Trigger.Source.FRAME_READOUT, edge(type - 14), 0);
      case 16, 17 -> new Trigger(timeUs, Trigger.Source.EXPOSURE, edge(type - 16), 0);
      default -> null;
    };
  }

  private static Trigger.Edge edge(int number) {
    return Trigger.Edge.values()[number];
  }

  private InertialSample inertial(ByteBuffer bytes) {
    boolean compass = packet.kind() == PacketHeader.INERTIAL_9;
    return new InertialSample(
        time(bytes, 4),
        bytes.getFloat(8),
        bytes.getFloat(12),
        bytes.getFloat(16),
        bytes.getFloat(20),
        bytes.getFloat(24),
        bytes.getFloat(28),
        bytes.getFloat(32),
        compass ? bytes.getFloat(36) : Float.NaN,
        compass ? bytes.getFloat(40) : Float.NaN,
        compass ? bytes.getFloat(44) : Float.NaN);
  }

  private Frame frame(ByteBuffer bytes, long offset) {
    int channels = bytes.getInt(0) >>> 1 & 7;
    int width = bytes.getInt(20);
    int height = bytes.getInt(24);
    int left = bytes.getInt(28);
    int top = bytes.getInt(32);
    long length = 2L * width * height * channels;
    if (width < 1
        || height < 1
        || width > Frame.MAX_SIDE
        || height > Frame.MAX_SIDE
        || channels < 1
        || channels > 4
        || length > bytes.limit() - FRAME_HEADER) {
      violations.add(Violation.INCOMPLETE_SAMPLE, offset);
      return null;
    }
    byte[] rows = new byte[(int) length];
    bytes.get(FRAME_HEADER, rows);
    boolean fromTop = geometry.origin() == Origin.TOP;
    return new Frame(
        new Frame.Times(time(bytes, 12), time(bytes, 16), time(bytes, 4), time(bytes, 8)),
        left,
        fromTop ? geometry.height() - top - height : top,
        width,
        height,
        channels,
        Frame.Depth.UNSIGNED_16,
        rows);
  }

  @Override
  public SensorSample sample() {
    return sample;
  }

  @Override
  public long offset() {
    return position + PacketHeader.BYTES + packet.payloadBytes();
  }

  /** The values are the offset and those of {@link Aedat3Decoder#save}. */
  @Override
  public void restore(long[] state, int at) {
    position = state[at] + state[at + 1] * Aedat3Decoder.EVENT_BYTES + state[at + 2];
    packet = null;
  }

  @Override
  public void close() {
    packet = null;
  }
}
