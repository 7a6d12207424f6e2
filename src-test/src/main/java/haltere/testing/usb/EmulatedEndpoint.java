package haltere.testing.usb;

import java.util.ArrayDeque;

/**
 * One endpoint of a device to the host: packets wait for transfers, transfers for packets.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class EmulatedEndpoint {
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

  private final EmulatedDevice device;
  private final ArrayDeque<Transfer> transfers = new ArrayDeque<>();
  private final ArrayDeque<byte[]> packets = new ArrayDeque<>();
  private boolean halted;

  EmulatedEndpoint(EmulatedDevice device) {
    this.device = device;
  }

  synchronized boolean offer(byte[] packet) {
    if (packets.size() >= device.maxQueuedPackets()) {
      device.packetDropped();
      return false;
    }
    packets.add(packet);
    pump();
    return true;
  }

  synchronized void submit(Transfer transfer) {
    if (device.isUnplugged()) {
      transfer.end(EmulatedDevice.ENODEV);
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
        end(transfer, EmulatedDevice.EPIPE);
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
        end(transfer, fits ? 0 : EmulatedDevice.EOVERFLOW);
      }
    }
  }

  private void end(Transfer transfer, int error) {
    if (!device.isUnplugged() && transfer.end(error)) {
      device.delivered(transfer.data, transfer.used);
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
