package haltere.testing.usb;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;

/**
 * A DVS128 (Cypress FX2, firmware 14) as seen over USB, with knobs for the faults that a driver
 * must survive.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class Dvs128Firmware implements Firmware {
  /** The endpoint of events. */
  public static final int ENDPOINT = 0x86;

  private static final int PACKET_BYTES = 512;
  private static final int WRAP = 0x80;
  private static final int RESET = 0x40;
  private static final int BIAS_BYTES = 36;
  private static final int LOW_BITS = 14;

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final AtomicLong eventsSent = new AtomicLong();
  private final String serial;
  private final ByteArrayOutputStream packet = new ByteArrayOutputStream();
  private volatile byte[] biases = {};
  private volatile boolean streaming;
  private volatile boolean refusingBiases;
  private volatile boolean busy;
  private volatile boolean master = true;
  private volatile EmulatedDevice device;
  private long wraps;

  /**
   * A camera.
   *
   * @param serial its number
   */
  public Dvs128Firmware(String serial) {
    this.serial = serial;
  }

  @Override
  public byte[] deviceDescriptor() {
    return Descriptors.bytes("12 01 00 02 00 00 00 40 2a 15 00 84 0e 00 01 02 03 01");
  }

  @Override
  public byte[] configurationDescriptor() {
    return Descriptors.bytes(
        "09 02 20 00 01 01 00 80 64"
            + "09 04 00 00 02 ff 00 00 00"
            + "07 05 81 02 40 00 00"
            + "07 05 86 02 00 02 00");
  }

  @Override
  public String string(int index) {
    return switch (index) {
      case 1 -> "INI";
      case 2 -> "DVS128-V1";
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
    for (int i = 0; i + 4 <= length; i += 4) {
      events += (data[i + 3] & 0xc0) == 0 && (data[i + 1] & 0x80) == 0 ? 1 : 0;
    }
    eventsSent.addAndGet(events);
  }

  /**
   * Pixel events that have gone over the wire to the host.
   *
   * @return an exact count
   */
  public long eventsSent() {
    // a delivery that is under way holds the endpoint until it is counted
    device.queued(ENDPOINT);
    return eventsSent.get();
  }

  @Override
  public int systemCall(int call) {
    return busy && call == UsbEmulator.CLAIM ? EmulatedDevice.EBUSY : 0;
  }

  @Override
  public byte[] control(ControlRequest request) {
    log.add(request.toString());
    if (request.type() == ControlRequest.TO_HOST && request.request() == 0xcb) {
      return new byte[] {(byte) 0xcb, (byte) (master ? 1 : 0)};
    }
    if (request.type() != ControlRequest.TO_DEVICE) {
      return null;
    }
    switch (request.request()) {
      case 0xb3 -> streaming = true;
      case 0xb4 -> streaming = false; // what is queued stays queued, and time continues
      case 0xb8 -> {
        if (refusingBiases || request.data().length != BIAS_BYTES) {
          return null;
        }
        biases = request.data().clone();
      }
      case 0xbb -> resetTimestamps();
      case 0xbe -> master = (request.value() & 1) != 0;
      case 0xc4 -> device.flush(ENDPOINT);
      case 0xb9, 0xbc, 0xbd, 0xcd -> {}
      default -> {
        return null;
      }
    }
    return new byte[0];
  }

  /**
   * The control requests so far.
   *
   * @return in their order, such as {@code 40:b3 v=0000 i=0000 n=0}
   */
  public List<String> log() {
    return log;
  }

  /**
   * The biases that were sent last.
   *
   * @return 36 bytes, or none
   */
  public byte[] biases() {
    return biases.clone();
  }

  /**
   * Whether it was started and not stopped.
   *
   * @return true while it may send
   */
  public boolean isStreaming() {
    return streaming;
  }

  /**
   * Stalls the request that writes biases.
   *
   * @param refuse whether it does
   */
  public void refuseBiases(boolean refuse) {
    refusingBiases = refuse;
  }

  /**
   * Denies claims, as if another program had the device.
   *
   * @param nowBusy whether it does
   */
  public void setBusy(boolean nowBusy) {
    busy = nowBusy;
  }

  /**
   * An event; wrap words go out on their own as time passes.
   *
   * @param timeUs microseconds on the camera's clock
   * @param x column, to the right
   * @param y row, upwards
   * @param on polarity
   */
  public synchronized void event(long timeUs, int x, int y, boolean on) {
    advance(timeUs);
    int address = y << 8 | 127 - x << 1 | (on ? 0 : 1);
    int low = (int) (timeUs & (1 << LOW_BITS) - 1);
    word(address & 0xff, address >> 8, low & 0xff, low >> 8);
  }

  /**
   * An edge on the input.
   *
   * @param timeUs microseconds on the camera's clock
   */
  public synchronized void trigger(long timeUs) {
    advance(timeUs);
    int low = (int) (timeUs & (1 << LOW_BITS) - 1);
    word(0, 0x80, low & 0xff, low >> 8);
  }

  /** The clock begins at 0 again. */
  public synchronized void resetTimestamps() {
    wraps = 0;
    word(0, 0, 0, RESET);
    if (streaming) {
      endPacket();
    }
  }

  /**
   * Time passes; wrap words go out.
   *
   * @param timeUs microseconds on the camera's clock
   */
  public synchronized void advance(long timeUs) {
    while (wraps < timeUs >> LOW_BITS) {
      wraps++;
      word(0, 0, 0, WRAP);
    }
  }

  /**
   * Time passes while the words for it get lost.
   *
   * @param count so many words
   */
  public synchronized void loseWraps(int count) {
    wraps += count;
  }

  /**
   * Sends bytes as they are.
   *
   * @param bytes any
   */
  public synchronized void garbage(byte... bytes) {
    packet.writeBytes(bytes);
    if (packet.size() >= PACKET_BYTES) {
      endPacket();
    }
  }

  private void word(int addressLow, int addressHigh, int timeLow, int timeHigh) {
    packet.write(addressLow);
    packet.write(addressHigh);
    packet.write(timeLow);
    packet.write(timeHigh);
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
