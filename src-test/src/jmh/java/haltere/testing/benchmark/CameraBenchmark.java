package haltere.testing.benchmark;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.device.model.UsbCameraProvider;
import haltere.device.protocol.Dvs128Decoder;
import haltere.device.usb.BulkTransfer;
import haltere.device.usb.TransferEnd;
import haltere.device.usb.TransferListener;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The driver of the DVS128 on one core: a bus that only says that transfers have ended, whose
 * buffers hold events already, and the consumer, on the same thread. {@code decoder} is the decoder
 * alone.
 *
 * <p>{@code ./gradlew jmh -Pbench=Camera}; figures are million events a second. What you should
 * see: 40 or more, and the decoder alone well above the whole.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class CameraBenchmark implements StreamHandler {
  private static final int TRANSFERS = 8;
  private static final int BYTES = 4096;
  private static final int EVENTS = BYTES / 4 - 1;

  private final QuietBus bus = new QuietBus();
  private final Dvs128Decoder decoder = new Dvs128Decoder(false);
  private final EventPacket packet = new EventPacket(EVENTS + 1);
  private final ByteBuffer words = ByteBuffer.allocateDirect(BYTES);
  private Camera camera;
  private long events;

  /** Opens and starts the camera. */
  @Setup
  public void start() throws IOException {
    fill(words);
    UsbCameraProvider provider = new UsbCameraProvider(bus);
    CameraOptions options =
        new CameraOptions(TRANSFERS, BYTES, TRANSFERS, WhenFull.DROP_NEWEST, false, false);
    camera = provider.open(provider.list().get(0), options);
    camera.next(this);
    // The clock was reset, as the driver asked; from then on it only continues.
    ByteBuffer first = bus.transfers.get(0).buffer;
    first.putInt(0, Integer.reverseBytes(0x4000_0000));
    bus.transfers.get(0).listener.ended(TransferEnd.COMPLETED, Integer.BYTES);
    while (camera.await(0)) {
      camera.next(this);
    }
    first.putInt(0, Integer.reverseBytes(0x8000_0000));
  }

  /** Events of a transfer, after the word that brings the clock on. */
  private static void fill(ByteBuffer buffer) {
    ByteBuffer filled = buffer.duplicate().order(ByteOrder.LITTLE_ENDIAN).clear();
    filled.putInt(0x8000_0000);
    for (int i = 0; i < EVENTS; i++) {
      filled.putInt(i * 16 << 16 | i * 37 & 0x7fff);
    }
  }

  /** From the end of eight transfers to their events in packets. */
  @Benchmark
  @OperationsPerInvocation(TRANSFERS * EVENTS)
  public long driverAndDecoder() throws IOException {
    long before = events;
    for (int i = 0; i < TRANSFERS; i++) {
      bus.transfers.get(i).listener.ended(TransferEnd.COMPLETED, BYTES);
    }
    while (camera.await(0)) {
      camera.next(this);
    }
    if (events - before != TRANSFERS * EVENTS) {
      throw new IllegalStateException(events - before + " events came: " + camera.statistics());
    }
    return events;
  }

  /** The same bytes, decoded only. */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public int decoder() {
    packet.clear();
    decoder.decode(words.rewind(), packet, EVENTS + 1);
    return packet.size();
  }

  @Override
  public void packet(EventPacket next) {
    events += next.size();
  }

  @Override
  public void notified(StreamNotification notification) {}

  private static final class QuietTransfer implements BulkTransfer {
    private final TransferListener listener;
    private ByteBuffer buffer;

    QuietTransfer(TransferListener listener) {
      this.listener = listener;
    }

    @Override
    public boolean submit(ByteBuffer into) {
      buffer = into;
      if (into.getInt(BYTES - Integer.BYTES) == 0) {
        fill(into);
      }
      return true;
    }

    @Override
    public void cancel() {
      listener.ended(TransferEnd.CANCELLED, 0);
    }
  }

  /** One DVS128 that agrees to everything. */
  private static final class QuietBus implements UsbBus {
    private final UsbDevice device = new UsbDevice(0x152a, 0x8400, 14, 1, 2);
    private final List<QuietTransfer> transfers = new ArrayList<>();

    @Override
    public List<UsbDevice> devices() {
      return List.of(device);
    }

    @Override
    public UsbTransport open(UsbDevice wanted) {
      return new UsbTransport() {
        @Override
        public UsbDevice device() {
          return wanted;
        }

        @Override
        public String serialNumber() {
          return "0001";
        }

        @Override
        public void claim() {}

        @Override
        public void send(int request, int value, int index, byte... data) {}

        @Override
        public byte[] query(int request, int value, int index, int length) {
          return new byte[length];
        }

        @Override
        public void write(int endpoint, byte... data) {}

        @Override
        public byte[] read(int endpoint, int most) {
          return new byte[0];
        }

        @Override
        public void clearHalt(int endpoint) {}

        @Override
        public BulkTransfer prepare(int endpoint, TransferListener listener) {
          QuietTransfer transfer = new QuietTransfer(listener);
          transfers.add(transfer);
          return transfer;
        }

        @Override
        public void free(Iterable<BulkTransfer> freed) {}

        @Override
        public void close() {}
      };
    }
  }
}
