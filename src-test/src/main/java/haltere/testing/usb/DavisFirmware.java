package haltere.testing.usb;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A DAVIS346B on a USB 3 board, logic version 18, as seen over USB. Its registers hold what they
 * were set to; which data it sends is up to the test.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class DavisFirmware implements Firmware {
  /** The endpoint of data. */
  public static final int ENDPOINT = 0x82;

  private static final int PACKET_BYTES = 512;
  private static final int TIME_BITS = 15;
  private static final int SIZE_X = 346;
  private static final int SIZE_Y = 260;

  private final String serial;
  private final Map<Integer, Integer> registers = new TreeMap<>();
  private final List<String> log = new CopyOnWriteArrayList<>();
  private final AtomicLong eventsSent = new AtomicLong();
  private final AtomicLong bytesSent = new AtomicLong();
  private final ByteArrayOutputStream packet = new ByteArrayOutputStream();
  private volatile EmulatedDevice device;
  private volatile int refusedRegister = -1;
  private long nowUs = -1;
  private long wraps;

  /**
   * A camera.
   *
   * @param serial its number
   */
  public DavisFirmware(String serial) {
    this.serial = serial;
    preset(6, 0, 18);
    preset(6, 1, 5);
    preset(6, 2, 1);
    preset(6, 3, 120);
    preset(6, 4, 30);
    preset(6, 5, 80);
    preset(6, 6, 1000);
    preset(6, 7, 1);
    preset(1, 0, SIZE_X);
    preset(1, 1, SIZE_Y);
    preset(1, 30, 1);
    preset(1, 40, 1);
    preset(2, 6, 1);
    preset(3, 0, 1);
  }

  /**
   * Sets a register, also one that the host can only read.
   *
   * @param module of the logic
   * @param parameter of the module
   * @param value 32 bits
   */
  public void preset(int module, int parameter, int value) {
    synchronized (registers) {
      registers.put(module << 16 | parameter, value);
    }
  }

  /**
   * Reads a register.
   *
   * @param module of the logic
   * @param parameter of the module
   * @return its value, 0 if nobody has set it
   */
  public int register(int module, int parameter) {
    synchronized (registers) {
      return registers.getOrDefault(module << 16 | parameter, 0);
    }
  }

  /**
   * Stalls every request to set a register.
   *
   * @param module of the logic
   * @param parameter of the module
   */
  public void refuse(int module, int parameter) {
    refusedRegister = module << 16 | parameter;
  }

  /**
   * The registers that were set, in order.
   *
   * @return such as {@code 0.3=1}
   */
  public List<String> log() {
    return log;
  }

  @Override
  public byte[] deviceDescriptor() {
    return Descriptors.bytes("12 01 00 02 00 00 00 40 2a 15 1a 84 06 00 01 02 03 01");
  }

  @Override
  public byte[] configurationDescriptor() {
    return Descriptors.bytes(
        "09 02 20 00 01 01 00 80 64"
            + "09 04 00 00 02 ff 00 00 00"
            + "07 05 81 03 40 00 01"
            + "07 05 82 02 00 02 00");
  }

  @Override
  public String string(int index) {
    return switch (index) {
      case 1 -> "iniVation";
      case 2 -> "DAVIS FX3";
      case 3 -> serial;
      default -> null;
    };
  }

  @Override
  public void attached(EmulatedDevice newDevice) {
    device = newDevice;
    newDevice.onDelivery(this::count);
  }

  private void count(byte[] data, int length) {
    long events = 0;
    for (int i = 1; i < length; i += 2) {
      int code = (data[i] & 0xff) >> 4;
      events += code == 2 || code == 3 ? 1 : 0;
    }
    eventsSent.addAndGet(events);
    bytesSent.addAndGet(length);
  }

  /**
   * Bytes of data that have gone over the wire to the host.
   *
   * @return an exact count
   */
  public long bytesSent() {
    return bytesSent.get();
  }

  /**
   * Events that have gone over the wire to the host.
   *
   * @return an exact count
   */
  public long eventsSent() {
    // a delivery that is under way holds the endpoint until it is counted
    device.queued(ENDPOINT);
    return eventsSent.get();
  }

  @Override
  public byte[] control(ControlRequest request) {
    if (request.type() == ControlRequest.TO_HOST && request.request() == 0xbf) {
      return ByteBuffer.allocate(4).putInt(register(request.value(), request.index())).array();
    }
    boolean refused = (request.value() << 16 | request.index()) == refusedRegister;
    if (request.type() != ControlRequest.TO_DEVICE || refused) {
      return null;
    }
    ByteBuffer data = ByteBuffer.wrap(request.data());
    if (request.request() == 0xbf && data.remaining() == 4) {
      set(request.value(), request.index(), data.getInt());
    } else if (request.request() == 0xc2 && data.remaining() == 6 * request.value()) {
      while (data.hasRemaining()) {
        set(data.get() & 0xff, data.get() & 0xff, data.getInt());
      }
    } else {
      return null;
    }
    return new byte[0];
  }

  private void set(int module, int parameter, int value) {
    log.add(module + "." + parameter + "=" + value);
    preset(module, parameter, value);
    if (module == 0 && parameter == 2 && value == 1) {
      resetTimestamps();
    }
  }

  /**
   * Whether it may send events.
   *
   * @return true once all switches are on
   */
  public boolean isStreaming() {
    return register(0, 0) == 1
        && register(0, 1) == 1
        && register(0, 3) == 1
        && register(9, 0) == 1
        && register(1, 3) == 1;
  }

  // ---- Words

  /** The clock begins at 0 again. */
  public synchronized void resetTimestamps() {
    wraps = 0;
    nowUs = -1;
    word(1);
    endPacket();
  }

  /**
   * An event.
   *
   * @param timeUs microseconds on the camera's clock
   * @param column from the left
   * @param row from the top
   * @param on polarity
   */
  public synchronized void event(long timeUs, int column, int row, boolean on) {
    time(timeUs);
    word(0x1000 | row);
    word((on ? 0x3000 : 0x2000) | column);
  }

  /**
   * A special word.
   *
   * @param timeUs microseconds on the camera's clock
   * @param code which
   */
  public synchronized void special(long timeUs, int code) {
    time(timeUs);
    word(code);
  }

  /**
   * An inertial sample of all three groups.
   *
   * @param timeUs microseconds on the camera's clock
   * @param accelerationRange 0 to 3
   * @param rotationRange 0 to 3
   * @param values x, y, z of the acceleration, temperature, x, y, z of the rotation
   */
  public synchronized void inertial(
      long timeUs, int accelerationRange, int rotationRange, int... values) {
    time(timeUs);
    word(5);
    word(0x5300 | 0xe0 | accelerationRange << 2 | rotationRange);
    for (int value : values) {
      word(0x5000 | value >> 8 & 0xff);
      word(0x5000 | value & 0xff);
    }
    word(7);
  }

  /**
   * A frame whose pixels all held 900 after their reset.
   *
   * @param timeUs microseconds of its start; it is exposed from 10 us to 110 us later
   * @param left first column
   * @param top first row
   * @param signals what the pixels held in the end, column by column
   */
  public synchronized void frame(long timeUs, int left, int top, int[][] signals) {
    time(timeUs);
    word(8);
    for (int number :
        new int[] {left, top, left + signals.length - 1, top + signals[0].length - 1}) {
      word(0x5100 | number >> 8);
      word(0x5200 | number & 0xff);
    }
    word(0x6000 | 100);
    time(timeUs + 10);
    word(14);
    for (int[] column : signals) {
      word(11);
      for (int i = 0; i < column.length; i++) {
        word(0x4000 | 900);
      }
      word(13);
    }
    time(timeUs + 110);
    word(15);
    for (int[] column : signals) {
      word(12);
      for (int value : column) {
        word(0x4000 | value);
      }
      word(13);
    }
    time(timeUs + 200);
    word(10);
  }

  private void time(long timeUs) {
    if (timeUs == nowUs) {
      return;
    }
    nowUs = timeUs;
    int passed = (int) ((timeUs >> TIME_BITS) - wraps);
    if (passed > 0) {
      wraps += passed;
      word(0x7000 | passed);
    }
    word(0x8000 | (int) (timeUs & (1 << TIME_BITS) - 1));
  }

  /**
   * Sends a word as it is.
   *
   * @param word 16 bits
   */
  public synchronized void word(int word) {
    packet.write(word);
    packet.write(word >> 8);
    if (packet.size() >= PACKET_BYTES) {
      endPacket();
    }
  }

  /** Ends the packet, as the timer of early packets does. */
  public synchronized void endPacket() {
    byte[] bytes = packet.toByteArray();
    packet.reset();
    if (bytes.length > 0) {
      device.send(ENDPOINT, bytes);
    }
  }
}
