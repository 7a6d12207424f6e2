package haltere.testing.usb;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.device.usb.BulkTransfer;
import haltere.device.usb.TransferEnd;
import haltere.device.usb.TransferListener;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/** An open device of a {@link MemoryBus}: transfers end on a thread of its own, as with libusb. */
final class MemoryTransport implements UsbTransport {
  private static final int SERIAL = 3;

  private final UsbDevice device;
  private final EmulatedDevice emulated;
  private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
  private final Thread thread = new Thread(this::handleEvents, "memory-usb");
  private volatile boolean closed;

  MemoryTransport(UsbDevice device, EmulatedDevice emulated) {
    this.device = device;
    this.emulated = emulated;
    thread.setDaemon(true);
    thread.start();
  }

  private void handleEvents() {
    try {
      while (!closed) {
        events.take().run();
      }
    } catch (InterruptedException nobodyDoes) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public UsbDevice device() {
    return device;
  }

  @Override
  public String serialNumber() throws CameraProblem {
    requirePlugged();
    String serial = emulated.firmware().string(SERIAL);
    return serial == null ? "" : serial.trim();
  }

  @Override
  public void claim() throws CameraProblem {
    requirePlugged();
    if (emulated.firmware().systemCall(UsbEmulator.CLAIM) != 0) {
      throw new CameraProblem(Kind.BUSY, "another program uses the camera; close that one first");
    }
  }

  @Override
  public void send(int request, int value, int index, byte... data) throws CameraProblem {
    control(new ControlRequest(ControlRequest.TO_DEVICE, request, value, index, data.length, data));
  }

  @Override
  public byte[] query(int request, int value, int index, int length) throws CameraProblem {
    byte[] answer =
        control(
            new ControlRequest(ControlRequest.TO_HOST, request, value, index, length, new byte[0]));
    return Arrays.copyOf(answer, length);
  }

  private synchronized byte[] control(ControlRequest request) throws CameraProblem {
    requirePlugged();
    if (emulated.isDeaf()) {
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(TIMEOUT_MS));
      throw new CameraProblem(
          Kind.TIMED_OUT, String.format("no answer to request 0x%02x", request.request()));
    }
    byte[] answer = emulated.control(request);
    if (answer == null) {
      throw new CameraProblem(
          Kind.REFUSED,
          String.format("the camera refused to obey request 0x%02x", request.request()));
    }
    return answer;
  }

  @Override
  public void write(int endpoint, byte... data) throws CameraProblem {
    requirePlugged();
    emulated.firmware().written(endpoint, data);
  }

  @Override
  public byte[] read(int endpoint, int maxBytes) throws CameraProblem {
    requirePlugged();
    CompletableFuture<byte[]> read = new CompletableFuture<>();
    EmulatedEndpoint.Transfer transfer =
        new EmulatedEndpoint.Transfer(
            maxBytes, (error, data, length) -> read.complete(Arrays.copyOf(data, length)));
    emulated.submit(endpoint, transfer);
    try {
      return read.get(TIMEOUT_MS, TimeUnit.MILLISECONDS);
    } catch (TimeoutException | ExecutionException | InterruptedException nothing) {
      emulated.discard(transfer);
      throw new CameraProblem(Kind.TIMED_OUT, "the camera did not answer a command");
    }
  }

  @Override
  public void clearHalt(int endpoint) throws CameraProblem {
    requirePlugged();
    emulated.halt(endpoint, false);
  }

  @Override
  public BulkTransfer prepare(int endpoint, TransferListener listener) {
    return new Bulk(endpoint, listener);
  }

  @Override
  public void free(Iterable<BulkTransfer> transfers) {
    for (BulkTransfer transfer : transfers) {
      if (((Bulk) transfer).underWay.get() != null) {
        throw new IllegalStateException("a transfer was freed that is under way");
      }
    }
  }

  @Override
  public void close() {
    closed = true;
    events.add(() -> {});
  }

  private void requirePlugged() throws CameraProblem {
    if (closed || emulated.isUnplugged()) {
      throw new CameraProblem(Kind.GONE, "the camera was unplugged");
    }
  }

  private final class Bulk implements BulkTransfer {
    private final int endpoint;
    private final TransferListener listener;
    private final AtomicReference<EmulatedEndpoint.Transfer> underWay = new AtomicReference<>();
    private ByteBuffer buffer;

    Bulk(int endpoint, TransferListener listener) {
      this.endpoint = endpoint;
      this.listener = listener;
    }

    @Override
    public boolean submit(ByteBuffer into) {
      if (closed) {
        throw new IllegalStateException("a transfer was started after the device was closed");
      }
      if (emulated.isUnplugged()) {
        return false;
      }
      buffer = into;
      EmulatedEndpoint.Transfer[] self = new EmulatedEndpoint.Transfer[1];
      self[0] =
          new EmulatedEndpoint.Transfer(
              into.capacity(), (error, data, length) -> end(self[0], error, data, length));
      underWay.set(self[0]);
      emulated.submit(endpoint, self[0]);
      return true;
    }

    private boolean end(EmulatedEndpoint.Transfer which, int error, byte[] data, int length) {
      if (underWay.compareAndSet(which, null)) {
        buffer.duplicate().clear().put(data, 0, length);
        events.add(() -> listener.ended(endOf(error), length));
        return true;
      }
      return false;
    }

    @Override
    public void cancel() {
      EmulatedEndpoint.Transfer which = underWay.get();
      if (which != null) {
        emulated.discard(which);
        end(which, EmulatedDevice.ENOENT, new byte[0], 0);
      }
    }
  }

  private static TransferEnd endOf(int error) {
    return switch (error) {
      case 0 -> TransferEnd.COMPLETED;
      case EmulatedDevice.ENOENT -> TransferEnd.CANCELLED;
      case EmulatedDevice.EPIPE -> TransferEnd.STALLED;
      case EmulatedDevice.EOVERFLOW -> TransferEnd.OVERFLOW;
      case EmulatedDevice.ENODEV -> TransferEnd.GONE;
      default -> TransferEnd.FAILED;
    };
  }
}
