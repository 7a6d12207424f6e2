package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import org.usb4java.DeviceHandle;
import org.usb4java.LibUsb;
import org.usb4java.Transfer;

/** A device that libusb has opened. Requests are serialised; closing waits for the last. */
final class LibusbTransport implements UsbTransport {
  private static final byte TO_DEVICE = 0x40;
  private static final byte FROM_DEVICE = (byte) 0xc0;
  private static final int INTERFACE = 0;
  private static final int CONFIGURATION = 1;

  private final UsbDevice device;
  private final DeviceHandle handle;
  private final int serialIndex;
  private final LibusbEvents events;
  private boolean claimed;
  private boolean closed;

  LibusbTransport(UsbDevice device, DeviceHandle handle, int serialIndex, LibusbEvents events) {
    this.device = device;
    this.handle = handle;
    this.serialIndex = serialIndex;
    this.events = events;
    events.join();
  }

  @Override
  public UsbDevice device() {
    return device;
  }

  @Override
  public BusWork work() {
    return events;
  }

  @Override
  public synchronized String serialNumber() throws CameraProblem {
    requireOpen();
    if (serialIndex == 0) {
      return "";
    }
    StringBuffer serial = new StringBuffer();
    LibusbProblem.check(
        LibUsb.getStringDescriptorAscii(handle, (byte) serialIndex, serial),
        "tell its serial number");
    return serial.toString().trim();
  }

  @Override
  public synchronized void claim() throws CameraProblem {
    requireOpen();
    IntBuffer active = IntBuffer.allocate(1);
    LibusbProblem.check(LibUsb.getConfiguration(handle, active), "tell its configuration");
    if (active.get(0) != CONFIGURATION) {
      LibusbProblem.check(LibUsb.setConfiguration(handle, CONFIGURATION), "take its configuration");
    }
    LibusbProblem.check(LibUsb.claimInterface(handle, INTERFACE), "let its interface be claimed");
    claimed = true;
  }

  @Override
  public synchronized void send(int request, int value, int index, byte... data)
      throws CameraProblem {
    requireOpen();
    ByteBuffer buffer = ByteBuffer.allocateDirect(data.length).put(data).rewind();
    int sent = control(TO_DEVICE, request, value, index, buffer);
    if (sent != data.length) {
      throw new CameraProblem(
          Kind.BROKEN, "the camera took " + sent + " of " + data.length + " bytes");
    }
  }

  @Override
  public synchronized byte[] query(int request, int value, int index, int length)
      throws CameraProblem {
    requireOpen();
    ByteBuffer buffer = ByteBuffer.allocateDirect(length);
    int received = control(FROM_DEVICE, request, value, index, buffer);
    if (received != length) {
      throw new CameraProblem(
          Kind.BROKEN, "the camera answered with " + received + " of " + length + " bytes");
    }
    byte[] answer = new byte[length];
    buffer.get(answer);
    return answer;
  }

  private int control(byte type, int request, int value, int index, ByteBuffer data)
      throws CameraProblem {
    int result =
        LibUsb.controlTransfer(
            handle, type, (byte) request, (short) value, (short) index, data, TIMEOUT_MS);
    return LibusbProblem.check(result, String.format("obey request 0x%02x", request));
  }

  @Override
  public synchronized void write(int endpoint, byte... data) throws CameraProblem {
    requireOpen();
    ByteBuffer buffer = ByteBuffer.allocateDirect(data.length).put(data).rewind();
    IntBuffer done = IntBuffer.allocate(1);
    LibusbProblem.check(
        LibUsb.bulkTransfer(handle, (byte) endpoint, buffer, done, TIMEOUT_MS), "take a command");
    if (done.get(0) != data.length) {
      throw new CameraProblem(
          Kind.BROKEN, "the camera took " + done.get(0) + " of " + data.length + " bytes");
    }
  }

  @Override
  public synchronized byte[] read(int endpoint, int maxBytes) throws CameraProblem {
    requireOpen();
    ByteBuffer buffer = ByteBuffer.allocateDirect(maxBytes);
    IntBuffer done = IntBuffer.allocate(1);
    LibusbProblem.check(
        LibUsb.bulkTransfer(handle, (byte) endpoint, buffer, done, TIMEOUT_MS), "answer a command");
    byte[] answer = new byte[done.get(0)];
    buffer.get(answer);
    return answer;
  }

  @Override
  public synchronized void clearHalt(int endpoint) throws CameraProblem {
    requireOpen();
    LibusbProblem.check(
        LibUsb.clearHalt(handle, (byte) endpoint),
        String.format("lift the halt of 0x%02x", endpoint));
  }

  @Override
  public BulkTransfer prepare(int endpoint, TransferListener listener) {
    return new Bulk(endpoint, listener);
  }

  @Override
  public void free(Iterable<BulkTransfer> transfers) {
    events.betweenEvents(
        () -> transfers.forEach(transfer -> LibUsb.freeTransfer(((Bulk) transfer).transfer)));
  }

  @Override
  public synchronized void close() {
    if (closed) {
      return;
    }
    closed = true;
    if (claimed) {
      LibUsb.releaseInterface(handle, INTERFACE);
    }
    LibUsb.close(handle);
    events.leave();
  }

  private void requireOpen() throws CameraProblem {
    if (closed) {
      throw new CameraProblem(Kind.GONE, "the camera is closed");
    }
  }

  private final class Bulk implements BulkTransfer {
    private final Transfer transfer = LibUsb.allocTransfer();
    private ByteBuffer buffer = ByteBuffer.allocateDirect(1);

    Bulk(int endpoint, TransferListener listener) {
      LibUsb.fillBulkTransfer(
          transfer,
          handle,
          (byte) endpoint,
          buffer,
          ended -> listener.ended(endOf(ended.status()), ended.actualLength()),
          null,
          0);
    }

    @Override
    public boolean submit(ByteBuffer into) {
      if (into != buffer) {
        buffer = into;
        transfer.setBuffer(into);
        transfer.setLength(into.capacity());
      }
      return LibUsb.submitTransfer(transfer) == LibUsb.SUCCESS;
    }

    @Override
    public void cancel() {
      LibUsb.cancelTransfer(transfer);
    }
  }

  private static TransferEnd endOf(int status) {
    return switch (status) {
      case LibUsb.TRANSFER_COMPLETED -> TransferEnd.COMPLETED;
      case LibUsb.TRANSFER_CANCELLED -> TransferEnd.CANCELLED;
      case LibUsb.TRANSFER_STALL -> TransferEnd.STALLED;
      case LibUsb.TRANSFER_OVERFLOW -> TransferEnd.OVERFLOW;
      case LibUsb.TRANSFER_NO_DEVICE -> TransferEnd.GONE;
      default -> TransferEnd.FAILED;
    };
  }
}
