package haltere.core.format.internal.aedat4;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.internal.compression.LittleEndian;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Collects samples into packets of their streams, in DV's layout. Each frame is a packet; inertial
 * samples and triggers within {@value #SPAN_US} us share one.
 *
 * <p>Thread rule: one thread.
 */
final class SamplePackets {
  private static final long SPAN_US = 50_000;
  private static final int MAX_ELEMENTS = 1024;
  private static final int MAX_SIDE = Short.MAX_VALUE;

  /** Numbers of the streams; 0 is that of events. */
  private static final Map<SampleKind, Integer> STREAMS =
      Map.of(SampleKind.FRAME, 1, SampleKind.INERTIAL_SAMPLE, 2, SampleKind.TRIGGER, 3);

  /** Receives complete packets. */
  @FunctionalInterface
  interface Target {
    /**
     * Writes a packet.
     *
     * @param stream number of its stream
     * @param payload not compressed
     * @param elements number of elements
     * @param firstUs time of the first
     * @param lastUs time of the last
     */
    void write(int stream, byte[] payload, int elements, long firstUs, long lastUs)
        throws IOException;
  }

  private final int sensorHeight;
  private final Set<SampleKind> kinds;
  private final Target target;
  private final Map<SampleKind, List<SensorSample>> gathered = new EnumMap<>(SampleKind.class);
  private long channelsLost;

  SamplePackets(int sensorHeight, Set<SampleKind> kinds, Target target) {
    this.sensorHeight = sensorHeight;
    this.kinds = kinds;
    this.target = target;
    for (SampleKind kind : SampleKind.values()) {
      gathered.put(kind, new ArrayList<>());
    }
  }

  /** Number of the stream of a kind. */
  static int stream(SampleKind kind) {
    return STREAMS.get(kind);
  }

  /** Four-letter type of a stream. */
  static String type(SampleKind kind) {
    return switch (kind) {
      case FRAME -> SamplePayload.FRAME;
      case INERTIAL_SAMPLE -> SamplePayload.INERTIAL;
      case TRIGGER -> SamplePayload.TRIGGERS;
    };
  }

  /** Adds a sample; false if the file has no stream that can hold it. */
  boolean add(SensorSample sample) throws IOException {
    if (!kinds.contains(sample.kind())) {
      return false;
    }
    if (sample instanceof Frame frame) {
      return write(frame);
    }
    if (sample instanceof Trigger trigger) {
      if (SamplePayload.triggerNumber(trigger) < 0) {
        return false;
      }
      channelsLost += trigger.channel() == 0 ? 0 : 1;
    }
    List<SensorSample> waiting = gathered.get(sample.kind());
    boolean falls =
        !waiting.isEmpty() && sample.timeUs() < waiting.get(waiting.size() - 1).timeUs();
    if (falls || waiting.size() == MAX_ELEMENTS) {
      flush(sample.kind());
    }
    waiting.add(sample);
    reached(sample.timeUs());
    return true;
  }

  /** Writes the packets that are due at a time. */
  void reached(long timeUs) throws IOException {
    for (SampleKind kind : kinds) {
      List<SensorSample> waiting = gathered.get(kind);
      if (!waiting.isEmpty() && Math.abs(timeUs - waiting.get(0).timeUs()) > SPAN_US) {
        flush(kind);
      }
    }
  }

  /** Writes the collected samples. */
  void flush() throws IOException {
    for (SampleKind kind : kinds) {
      flush(kind);
    }
  }

  /** Number of triggers whose input number could not be written. */
  long channelsLost() {
    return channelsLost;
  }

  private void flush(SampleKind kind) throws IOException {
    List<SensorSample> waiting = gathered.get(kind);
    if (waiting.isEmpty()) {
      return;
    }
    byte[] payload = kind == SampleKind.TRIGGER ? triggers(waiting) : samples(waiting);
    target.write(
        STREAMS.get(kind),
        payload,
        waiting.size(),
        waiting.get(0).timeUs(),
        waiting.get(waiting.size() - 1).timeUs());
    waiting.clear();
  }

  private static byte[] triggers(List<SensorSample> triggers) {
    VectorPayload vector =
        new VectorPayload(SamplePayload.TRIGGERS, triggers.size(), 16, 13, 4, 12);
    for (int i = 0; i < triggers.size(); i++) {
      Trigger trigger = (Trigger) triggers.get(i);
      int at = vector.element(i);
      LittleEndian.putLong(vector.bytes(), at + 4, trigger.timeUs());
      vector.bytes()[at + 12] = (byte) SamplePayload.triggerNumber(trigger);
    }
    return vector.bytes();
  }

  private static byte[] samples(List<SensorSample> samples) {
    VectorPayload vector =
        new VectorPayload(
            SamplePayload.INERTIAL,
            samples.size(),
            56,
            52,
            4,
            12,
            16,
            20,
            24,
            28,
            32,
            36,
            40,
            44,
            48);
    for (int i = 0; i < samples.size(); i++) {
      InertialSample sample = (InertialSample) samples.get(i);
      int at = vector.element(i);
      LittleEndian.putLong(vector.bytes(), at + 4, sample.timeUs());
      float[] values = {
        sample.temperatureC(),
        sample.accelerationXG(),
        sample.accelerationYG(),
        sample.accelerationZG(),
        sample.rotationXDegS(),
        sample.rotationYDegS(),
        sample.rotationZDegS(),
        sample.magneticXMicrotesla(),
        sample.magneticYMicrotesla(),
        sample.magneticZMicrotesla()
      };
      for (int value = 0; value < values.length; value++) {
        LittleEndian.putInt(
            vector.bytes(), at + 12 + 4 * value, Float.floatToRawIntBits(values[value]));
      }
    }
    return vector.bytes();
  }

  /** A vector of tables that all have the same layout. */
  private static final class VectorPayload {
    private final byte[] bytes;
    private final int first;
    private final int stride;

    /** The offsets are those of the fields in a table; the first field has 8 bytes. */
    VectorPayload(String type, int elements, int stride, int size, int... offsets) {
      this.stride = stride;
      int layout = 28;
      int vector = (layout + 4 + 2 * offsets.length + 3) & -4;
      first = ((vector + 4 + 4 * elements + 7) & -8) + 4;
      bytes = FlatPayload.start(type, first + stride * elements);
      FlatPayload.putLayout(bytes, 14, 8, 4);
      LittleEndian.putInt(bytes, 4, 16);
      LittleEndian.putInt(bytes, 20, 6);
      LittleEndian.putInt(bytes, 24, vector - 24);
      FlatPayload.putLayout(bytes, layout, size, offsets);
      LittleEndian.putInt(bytes, vector, elements);
      for (int i = 0; i < elements; i++) {
        int slot = vector + 4 + 4 * i;
        LittleEndian.putInt(bytes, slot, element(i) - slot);
        LittleEndian.putInt(bytes, element(i), element(i) - layout);
      }
    }

    byte[] bytes() {
      return bytes;
    }

    int element(int index) {
      return first + stride * index;
    }
  }

  private boolean write(Frame frame) throws IOException {
    int top = sensorHeight - frame.bottom() - frame.height();
    if (frame.width() > MAX_SIDE
        || frame.height() > MAX_SIDE
        || (short) frame.left() != frame.left()
        || (short) top != top) {
      return false;
    }
    int table = 44;
    int vector = 112;
    int length = frame.rows().limit();
    byte[] bytes = FlatPayload.start(SamplePayload.FRAME, vector + 4 + length);
    LittleEndian.putInt(bytes, 4, table - 4);
    FlatPayload.putLayout(bytes, 14, 68, 20, 28, 36, 44, 52, 16, 8, 10, 12, 14, 4, 60, 17);
    LittleEndian.putInt(bytes, table, table - 14);
    LittleEndian.putInt(bytes, table + 4, vector - table - 4);
    LittleEndian.putShort(bytes, table + 8, frame.width());
    LittleEndian.putShort(bytes, table + 10, frame.height());
    LittleEndian.putShort(bytes, table + 12, frame.left());
    LittleEndian.putShort(bytes, table + 14, top);
    int depth = List.of(SamplePayload.DEPTHS).indexOf(frame.depth());
    bytes[table + 16] = (byte) (depth | frame.channels() - 1 << 3);
    Frame.Times times = frame.times();
    LittleEndian.putLong(bytes, table + 20, times.exposureStartUs());
    LittleEndian.putLong(bytes, table + 28, times.readoutStartUs());
    LittleEndian.putLong(bytes, table + 36, times.readoutEndUs());
    LittleEndian.putLong(bytes, table + 44, times.exposureStartUs());
    LittleEndian.putLong(bytes, table + 52, times.exposureEndUs());
    LittleEndian.putLong(bytes, table + 60, times.exposureEndUs() - times.exposureStartUs());
    LittleEndian.putInt(bytes, vector, length);
    byte[] rows = new byte[length];
    frame.rows().get(rows);
    if (frame.channels() >= 3) {
      SamplePayload.swapRedAndBlue(rows, frame.channels(), frame.depth().bytes());
    }
    System.arraycopy(rows, 0, bytes, vector + 4, length);
    target.write(STREAMS.get(SampleKind.FRAME), bytes, 1, frame.timeUs(), frame.timeUs());
    return true;
  }
}
