package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;

/** A device whose transfers end when a test says so, and how it says. */
final class ManualTransfers implements UsbTransport {
  /** One of them. */
  final class ManualTransfer implements BulkTransfer {
    private final TransferListener listener;
    private ByteBuffer buffer;
    volatile int started;
    volatile boolean cancelled;

    ManualTransfer(TransferListener listener) {
      this.listener = listener;
    }

    @Override
    public boolean submit(ByteBuffer into) {
      if (refusing) {
        return false;
      }
      buffer = into;
      started = started + 1;
      cancelled = false;
      return true;
    }

    @Override
    public void cancel() {
      cancelled = true;
    }

    /** Ends it with so many events of a DVS128, all bits 0. */
    void end(TransferEnd end, int events) {
      int bytes = events * Integer.BYTES;
      buffer.duplicate().clear().put(new byte[bytes]);
      listener.ended(end, bytes);
    }
  }

  final List<ManualTransfer> transfers = new ArrayList<>();
  boolean refusing;
  int freed;
  int haltsCleared;

  @Override
  public BulkTransfer prepare(int endpoint, TransferListener listener) {
    ManualTransfer fresh = new ManualTransfer(listener);
    transfers.add(fresh);
    return fresh;
  }

  @Override
  public void free(Iterable<BulkTransfer> these) {
    these.forEach(transfer -> freed++);
  }

  @Override
  public void clearHalt(int endpoint) {
    haltsCleared++;
  }

  @Override
  public UsbDevice device() {
    return new UsbDevice(1, 2, 3, 4, 5);
  }

  @Override
  public String serialNumber() {
    return "";
  }

  @Override
  public void claim() {}

  @Override
  public void send(int request, int value, int index, byte... data) throws CameraProblem {
    throw nothingToAsk();
  }

  @Override
  public byte[] query(int request, int value, int index, int length) throws CameraProblem {
    throw nothingToAsk();
  }

  @Override
  public void write(int endpoint, byte... data) throws CameraProblem {
    throw nothingToAsk();
  }

  @Override
  public byte[] read(int endpoint, int most) throws CameraProblem {
    throw nothingToAsk();
  }

  private static CameraProblem nothingToAsk() {
    return new CameraProblem(CameraProblem.Kind.REFUSED, "it has transfers only");
  }

  @Override
  public void close() {}
}
