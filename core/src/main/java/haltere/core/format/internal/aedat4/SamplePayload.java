package haltere.core.format.internal.aedat4;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import java.util.Collection;

/**
 * Converts payloads to samples. A frame's format is an OpenCV type: depth in the lowest three bits,
 * channels less one above; the colour order is converted from blue, green, red to red, green, blue.
 * Missing times of a frame are derived from the others.
 *
 * @param sensorHeight rows of the sensor, 0 if not known
 * @param rowsFromBottom whether the file counts rows from the bottom
 */
record SamplePayload(int sensorHeight, boolean rowsFromBottom) {
  static final String FRAME = "FRME";
  static final String INERTIAL = "IMUS";
  static final String TRIGGERS = "TRIG";

  /**
   * Depths in the order of OpenCV's numbers; the eighth, half precision, is converted to 32 bits.
   */
  static final Frame.Depth[] DEPTHS = {
    Frame.Depth.UNSIGNED_8,
    Frame.Depth.SIGNED_8,
    Frame.Depth.UNSIGNED_16,
    Frame.Depth.SIGNED_16,
    Frame.Depth.SIGNED_32,
    Frame.Depth.FLOAT_32,
    Frame.Depth.FLOAT_64,
    Frame.Depth.FLOAT_32
  };

  private static final int HALF = 7;

  /** Triggers in the order of their numbers in the file. */
  private static final Trigger.Source[] SOURCES = {
    Trigger.Source.CLOCK_RESET,
    Trigger.Source.EXTERNAL_INPUT,
    Trigger.Source.EXTERNAL_INPUT,
    Trigger.Source.EXTERNAL_INPUT,
    Trigger.Source.SIGNAL_GENERATOR,
    Trigger.Source.SIGNAL_GENERATOR,
    Trigger.Source.FRAME_READOUT,
    Trigger.Source.FRAME_READOUT,
    Trigger.Source.EXPOSURE,
    Trigger.Source.EXPOSURE
  };

  private static final Trigger.Edge[] EDGES = {
    Trigger.Edge.PULSE,
    Trigger.Edge.RISING,
    Trigger.Edge.FALLING,
    Trigger.Edge.PULSE,
    Trigger.Edge.RISING,
    Trigger.Edge.FALLING,
    Trigger.Edge.RISING,
    Trigger.Edge.FALLING,
    Trigger.Edge.RISING,
    Trigger.Edge.FALLING
  };

  static boolean isKnown(String type) {
    return type.equals(FRAME) || type.equals(INERTIAL) || type.equals(TRIGGERS);
  }

  /** Number of a trigger in the file, or -1 if it has none. */
  static int triggerNumber(Trigger trigger) {
    for (int number = 0; number < SOURCES.length; number++) {
      if (SOURCES[number] == trigger.source() && EDGES[number] == trigger.edge()) {
        return number;
      }
    }
    return -1;
  }

  void read(String type, byte[] data, int from, int to, Collection<SensorSample> found)
      throws DamagedPacketException {
    FlatTable table = FlatTable.root(data, from, to);
    if (type.equals(FRAME)) {
      found.add(frame(table, data, to));
      return;
    }
    long elements = table.vectorLength(0);
    if (elements > (to - from) / 4) {
      throw new DamagedPacketException("fewer elements than it says");
    }
    for (int i = 0; i < elements; i++) {
      FlatTable element = table.vectorTable(0, i);
      if (type.equals(INERTIAL)) {
        found.add(inertial(element, data));
      } else {
        int number = (byte) byteOf(element, 1, data);
        if (number >= 0 && number < SOURCES.length) {
          long timeUs = element.getLong(0, 0);
          found.add(new Trigger(timeUs, SOURCES[number], EDGES[number], 0));
        }
      }
    }
  }

  private static int byteOf(FlatTable table, int index, byte[] data) throws DamagedPacketException {
    int at = table.position(index, 1);
    return at < 0 ? 0 : data[at];
  }

  private static int shortOf(FlatTable table, int index, byte[] data)
      throws DamagedPacketException {
    int at = table.position(index, 2);
    return at < 0 ? 0 : (short) LittleEndian.getUnsignedShort(data, at);
  }

  private static float floatOf(FlatTable table, int index) throws DamagedPacketException {
    return Float.intBitsToFloat(table.getInt(index, 0));
  }

  private static InertialSample inertial(FlatTable table, byte[] data)
      throws DamagedPacketException {
    return new InertialSample(
        table.getLong(0, 0),
        floatOf(table, 2),
        floatOf(table, 3),
        floatOf(table, 4),
        floatOf(table, 5),
        floatOf(table, 6),
        floatOf(table, 7),
        floatOf(table, 1),
        floatOf(table, 8),
        floatOf(table, 9),
        floatOf(table, 10));
  }

  private Frame frame(FlatTable table, byte[] data, int end) throws DamagedPacketException {
    int format = byteOf(table, 5, data);
    int width = shortOf(table, 6, data);
    int height = shortOf(table, 7, data);
    int left = shortOf(table, 8, data);
    int top = shortOf(table, 9, data);
    int channels = (format >> 3) + 1;
    boolean possible = format >= 0 && channels <= 4 && width > 0 && height > 0;
    if (!possible || width > Frame.MAX_SIDE || height > Frame.MAX_SIDE) {
      throw new DamagedPacketException("a frame of impossible size");
    }
    boolean half = (format & HALF) == HALF;
    Frame.Depth depth = DEPTHS[format & 7];
    long values = (long) width * height * channels;
    long bytes = table.vectorLength(10);
    if (depth == Frame.Depth.UNSIGNED_8 && bytes == 2 * values) {
      // jAER states eight bits and writes sixteen
      depth = Frame.Depth.UNSIGNED_16;
    }
    int at = table.vectorElements(10);
    if (at < 0 || bytes != values * (half ? 2 : depth.bytes()) || at + bytes > end) {
      throw new DamagedPacketException("a frame without its pixels");
    }
    byte[] rows = half ? widened(data, at, (int) values) : new byte[(int) bytes];
    if (!half) {
      System.arraycopy(data, at, rows, 0, rows.length);
    }
    if (channels >= 3) {
      swapRedAndBlue(rows, channels, depth.bytes());
    }
    if (rowsFromBottom) {
      flipRows(rows, height);
    }
    int bottom = rowsFromBottom || sensorHeight == 0 ? top : sensorHeight - top - height;
    return new Frame(times(table), left, bottom, width, height, channels, depth, rows);
  }

  private static Frame.Times times(FlatTable table) throws DamagedPacketException {
    long timeUs = table.getLong(0, 0);
    long startUs = table.getLong(3, timeUs);
    long endUs = table.getLong(4, startUs + Math.max(0, table.getLong(11, 0)));
    return new Frame.Times(startUs, endUs, table.getLong(1, startUs), table.getLong(2, endUs));
  }

  /** Converts half precision (16 bits) to single precision (32 bits). */
  private static byte[] widened(byte[] data, int at, int values) {
    byte[] wide = new byte[4 * values];
    for (int i = 0; i < values; i++) {
      int bits = LittleEndian.getUnsignedShort(data, at + 2 * i);
      int exponent = bits >> 10 & 0x1f;
      int fraction = bits & 0x3ff;
      float size =
          switch (exponent) {
            case 0 -> Math.scalb((float) fraction, -24);
            case 0x1f -> fraction == 0 ? Float.POSITIVE_INFINITY : Float.NaN;
            default -> Math.scalb((float) (0x400 + fraction), exponent - 25);
          };
      float value = bits >= 0x8000 ? -size : size;
      LittleEndian.putInt(wide, 4 * i, Float.floatToIntBits(value));
    }
    return wide;
  }

  static void swapRedAndBlue(byte[] rows, int channels, int bytes) {
    for (int at = 0; at < rows.length; at += channels * bytes) {
      for (int i = at; i < at + bytes; i++) {
        byte first = rows[i];
        rows[i] = rows[i + 2 * bytes];
        rows[i + 2 * bytes] = first;
      }
    }
  }

  private static void flipRows(byte[] rows, int height) {
    int length = rows.length / height;
    byte[] row = new byte[length];
    for (int upper = 0, lower = height - 1; upper < lower; upper++, lower--) {
      System.arraycopy(rows, upper * length, row, 0, length);
      System.arraycopy(rows, lower * length, rows, upper * length, length);
      System.arraycopy(row, 0, rows, lower * length, length);
    }
  }
}
