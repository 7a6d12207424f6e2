package haltere.testing.usb;

import java.util.ArrayDeque;
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
  private static final int HIGH_SPEED_PACKET = 512;

  /** A transfer from the device that waits for data. */
  static final class Transfer {
    private final byte[] data;
    private final Answer answer;
    private int used;

    Transfer(int length, Answer answer) {
      data = new byte[length];
      this.answer = answer;
    }

    private boolean end(int error) {
      return answer.end(error, data, used);
    }
  }

  /** Told of the end of a transfer. */
  interface Answer {
    /**
     * The first {@code length} bytes of the data have come; the error is 0 or negative. Returns
     * whether this reached the host.
     */
    boolean end(int error, byte[] data, int length);
  }

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
  private final Map<Integer, Endpoint> endpoints = new HashMap<>();
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
   * Lets nobody open it, as the system does for a user without the right.
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
   * @param packets so many at the most; more are dropped
   */
  public void limitQueue(int packets) {
    maxQueuedPackets = packets;
  }

  /**
   * Tells somebody of all data that went to the host.
   *
   * @param newDelivery told, on the thread that sends
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

  // ---- The host's side

  void submit(int endpoint, Transfer transfer) {
    endpoint(endpoint).submit(transfer);
  }

  /** Takes transfers back without ending them. */
  void discard(Transfer transfer) {
    for (Endpoint endpoint : allEndpoints()) {
      endpoint.discard(transfer);
    }
  }

  /** Forgets all transfers, as when the host closes the device. */
  void discardAll() {
    allEndpoints().forEach(Endpoint::discardAll);
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

  private Endpoint endpoint(int address) {
    synchronized (endpoints) {
      return endpoints.computeIfAbsent(address, unused -> new Endpoint());
    }
  }

  private List<Endpoint> allEndpoints() {
    synchronized (endpoints) {
      return List.copyOf(endpoints.values());
    }
  }

  /** One endpoint to the host. */
  private final class Endpoint {
    private final ArrayDeque<Transfer> transfers = new ArrayDeque<>();
    private final ArrayDeque<byte[]> packets = new ArrayDeque<>();
    private boolean halted;

    synchronized boolean offer(byte[] packet) {
      if (packets.size() >= maxQueuedPackets) {
        packetsDropped.incrementAndGet();
        return false;
      }
      packets.add(packet);
      pump();
      return true;
    }

    synchronized void submit(Transfer transfer) {
      if (gone) {
        transfer.end(ENODEV);
        return;
      }
      transfers.add(transfer);
      pump();
    }

    private void pump() {
      while (!transfers.isEmpty()) {
        Transfer transfer = transfers.peek();
        if (halted) {
          transfers.poll();
          end(transfer, EPIPE);
          continue;
        }
        byte[] packet = packets.poll();
        if (packet == null) {
          return;
        }
        boolean fits = packet.length <= transfer.data.length - transfer.used;
        if (fits) {
          System.arraycopy(packet, 0, transfer.data, transfer.used, packet.length);
          transfer.used += packet.length;
        }
        if (!fits || packet.length < HIGH_SPEED_PACKET || transfer.used == transfer.data.length) {
          transfers.poll();
          end(transfer, fits ? 0 : EOVERFLOW);
        }
      }
    }

    private void end(Transfer transfer, int error) {
      if (!gone && transfer.end(error)) {
        delivery.delivered(transfer.data, transfer.used);
      }
    }

    synchronized void halt(boolean on) {
      halted = on;
      pump();
    }

    synchronized void failNext(int error) {
      Transfer transfer = transfers.poll();
      if (transfer != null) {
        transfer.used = 0;
        end(transfer, error);
      }
    }

    synchronized void endAll(int error) {
      for (Transfer transfer : transfers) {
        transfer.used = 0;
        transfer.end(error);
      }
      transfers.clear();
    }

    synchronized void discard(Transfer transfer) {
      transfers.remove(transfer);
    }

    synchronized void discardAll() {
      transfers.clear();
    }

    synchronized int waiting() {
      return transfers.size();
    }

    synchronized int queued() {
      return packets.size();
    }

    synchronized void flush() {
      packets.clear();
    }
  }

  @Override
  public String toString() {
    return "device " + number + " " + Arrays.toString(firmware.deviceDescriptor());
  }
}
