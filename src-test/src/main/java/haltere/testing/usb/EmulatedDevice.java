package haltere.testing.usb;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.LockSupport;

/**
 * A device that is plugged in: USB packets behave as on a bus. A short packet ends a transfer, one
 * that does not fit is an overflow, a halted endpoint stalls. Knobs inject faults.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class EmulatedDevice {
  /** Error numbers of Linux, as the bus gives them. */
  public static final int ENOENT = -2;

  /** The interface belongs to another program. */
  public static final int EBUSY = -16;

  /** The device is gone. */
  public static final int ENODEV = -19;

  /** The endpoint is halted, or the request is not known. */
  public static final int EPIPE = -32;

  /** Something went wrong on the wire. */
  public static final int EPROTO = -71;

  /** More came than fits. */
  public static final int EOVERFLOW = -75;

  private static final int STANDARD_TO_HOST = 0x80;
  private static final int GET_DESCRIPTOR = 6;

  /** Told of bytes that the host has got. */
  @FunctionalInterface
  public interface Delivery {
    /**
     * Bytes went to the host.
     *
     * @param data their array
     * @param length how many
     */
    void delivered(byte[] data, int length);
  }

  private final int number;
  private final Firmware firmware;
  private final Map<Integer, EmulatedEndpoint> endpoints = new HashMap<>();
  private final AtomicLong packetsDropped = new AtomicLong();
  private volatile int controlDelayMs;
  private volatile boolean deaf;
  private volatile boolean forbidden;
  private volatile int maxQueuedPackets = Integer.MAX_VALUE;
  private volatile Delivery delivery = (data, length) -> {};
  private volatile Runnable unplugging = () -> {};
  private volatile Runnable forbidding = () -> {};
  private volatile boolean gone;

  EmulatedDevice(int number, Firmware firmware) {
    this.number = number;
    this.firmware = firmware;
  }

  /** Its address on the bus. */
  int number() {
    return number;
  }

  Firmware firmware() {
    return firmware;
  }

  boolean isDeaf() {
    return deaf;
  }

  boolean isForbidden() {
    return forbidden;
  }

  /**
   * Whether the plug was pulled.
   *
   * @return true from then on
   */
  public boolean isUnplugged() {
    return gone;
  }

  void onForbidden(Runnable action) {
    forbidding = action;
  }

  void onUnplug(Runnable action) {
    unplugging = action;
  }

  // ---- Knobs

  /**
   * Makes every answer to a control request late.
   *
   * @param delayMs milliseconds
   */
  public void delayControl(int delayMs) {
    controlDelayMs = delayMs;
  }

  /**
   * Leaves control requests without an answer.
   *
   * @param nowDeaf whether it does
   */
  public void setDeaf(boolean nowDeaf) {
    deaf = nowDeaf;
  }

  /**
   * Denies access, as the system does for a user without permission.
   *
   * @param nowForbidden whether it does
   */
  public void setForbidden(boolean nowForbidden) {
    forbidden = nowForbidden;
    forbidding.run();
  }

  /**
   * Bounds the device's own queue of packets.
   *
   * @param packets so many at most; more are dropped
   */
  public void limitQueue(int packets) {
    maxQueuedPackets = packets;
  }

  /**
   * Sets a listener of all data sent to the host.
   *
   * @param newDelivery called on the sending thread
   */
  public void onDelivery(Delivery newDelivery) {
    delivery = newDelivery;
  }

  /** Pulls the plug. */
  public void unplug() {
    if (!gone) {
      gone = true;
      unplugging.run();
    }
  }

  // ---- The device's side

  /**
   * Sends one USB packet.
   *
   * @param endpoint address, 0x80 or more
   * @param packet at most 512 bytes; shorter ones end a transfer
   * @return false if the device's queue was full and the packet is lost
   */
  public boolean send(int endpoint, byte[] packet) {
    return endpoint(endpoint).offer(packet);
  }

  /**
   * Halts an endpoint or lifts its halt.
   *
   * @param endpoint address
   * @param on whether it is halted
   */
  public void halt(int endpoint, boolean on) {
    endpoint(endpoint).halt(on);
  }

  /**
   * Ends the oldest waiting transfer with an error.
   *
   * @param endpoint address
   * @param error such as {@link #EPROTO}
   */
  public void failNext(int endpoint, int error) {
    endpoint(endpoint).failNext(error);
  }

  /**
   * Transfers that wait for data.
   *
   * @param endpoint address
   * @return a count
   */
  public int waiting(int endpoint) {
    return endpoint(endpoint).waiting();
  }

  /**
   * Packets that wait for a transfer.
   *
   * @param endpoint address
   * @return a count
   */
  public int queued(int endpoint) {
    return endpoint(endpoint).queued();
  }

  /**
   * Throws packets away that wait for a transfer.
   *
   * @param endpoint address
   */
  public void flush(int endpoint) {
    endpoint(endpoint).flush();
  }

  /**
   * Packets that did not fit into the device's queue.
   *
   * @return a count
   */
  public long packetsDropped() {
    return packetsDropped.get();
  }

  /** Maximum number of packets waiting at an endpoint. */
  int maxQueuedPackets() {
    return maxQueuedPackets;
  }

  void packetDropped() {
    packetsDropped.incrementAndGet();
  }

  void delivered(byte[] data, int length) {
    delivery.delivered(data, length);
  }

  // ---- The host's side

  void submit(int endpoint, EmulatedEndpoint.Transfer transfer) {
    endpoint(endpoint).submit(transfer);
  }

  /** Takes transfers back without ending them. */
  void discard(EmulatedEndpoint.Transfer transfer) {
    for (EmulatedEndpoint endpoint : allEndpoints()) {
      endpoint.discard(transfer);
    }
  }

  /** Forgets all transfers, as when the host closes the device. */
  void discardAll() {
    allEndpoints().forEach(EmulatedEndpoint::discardAll);
  }

  /** Ends all transfers: the device is gone. */
  void endAll() {
    allEndpoints().forEach(endpoint -> endpoint.endAll(ENODEV));
  }

  /** Answers a control request; null stalls it. The caller looks at {@link #isDeaf} before. */
  byte[] control(ControlRequest request) {
    if (controlDelayMs > 0) {
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(controlDelayMs));
    }
    return request.type() == STANDARD_TO_HOST && request.request() == GET_DESCRIPTOR
        ? descriptor(request.value())
        : firmware.control(request);
  }

  private byte[] descriptor(int value) {
    return switch (value >> 8) {
      case 1 -> firmware.deviceDescriptor();
      case 2 -> firmware.configurationDescriptor();
      case 3 -> Descriptors.string(firmware, value & 0xff);
      default -> null;
    };
  }

  private EmulatedEndpoint endpoint(int address) {
    synchronized (endpoints) {
      return endpoints.computeIfAbsent(address, unused -> new EmulatedEndpoint(this));
    }
  }

  private List<EmulatedEndpoint> allEndpoints() {
    synchronized (endpoints) {
      return List.copyOf(endpoints.values());
    }
  }

  @Override
  public String toString() {
    return "device " + number + " " + Arrays.toString(firmware.deviceDescriptor());
  }
}
