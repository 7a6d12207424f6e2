package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.camera.CameraProvider;
import haltere.device.usb.LibusbBus;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.Supplier;

/**
 * Cameras on USB: DVS128, DAVIS240, DAVIS346, and, as an experiment, the EVK4. Found as a service.
 */
public final class UsbCameraProvider implements CameraProvider {
  private final Supplier<UsbBus> bus;
  private final List<CameraModel> models;
  private final SearchSchedule.Pace pace;

  /** Serial numbers that only a claimed device tells, for the time while it is in use. */
  private final Map<UsbDevice, String> serials = new ConcurrentHashMap<>();

  /** The cameras on this computer's USB, through libusb. */
  public UsbCameraProvider() {
    this(LibusbBus::shared, LockSupport::parkNanos, SearchSchedule.Pace.DEFAULT);
  }

  /**
   * The cameras on a bus.
   *
   * @param bus the bus to search
   */
  public UsbCameraProvider(UsbBus bus) {
    this(() -> bus, LockSupport::parkNanos, SearchSchedule.Pace.DEFAULT);
  }

  /**
   * The cameras on a bus.
   *
   * @param bus the bus to search
   * @param pause waits a number of nanoseconds for a camera to become ready
   * @param pace intervals of the search for an unplugged camera
   */
  UsbCameraProvider(Supplier<UsbBus> bus, LongConsumer pause, SearchSchedule.Pace pace) {
    this.bus = bus;
    this.pace = pace;
    List<CameraModel> all = new ArrayList<>();
    all.add(new Dvs128Model());
    all.add(new DavisModel(pause));
    all.add(new EvkModel());
    all.addAll(KnownCamera.ALL);
    models = List.copyOf(all);
  }

  @Override
  public String name() {
    return "usb";
  }

  @Override
  public List<CameraInfo> list() {
    try {
      return seen().stream().map(Seen::info).sorted(Comparator.comparing(CameraInfo::id)).toList();
    } catch (CameraProblem ignored) {
      return List.of();
    }
  }

  @Override
  public Optional<Watch> watch(Runnable changed) {
    try {
      return bus.get().watch(changed).map(watch -> watch::close);
    } catch (CameraProblem ignored) {
      return Optional.empty();
    }
  }

  @Override
  public Optional<String> obstacle() {
    try {
      bus.get().devices();
      return Optional.empty();
    } catch (CameraProblem noUsb) {
      return Optional.of(noUsb.getMessage());
    }
  }

  @Override
  public Camera open(CameraInfo info, CameraOptions options) throws CameraProblem {
    for (Seen seen : seen()) {
      if (seen.info.id().equals(info.id())) {
        if (!seen.model.obstacle().isEmpty()) {
          throw new CameraProblem(Kind.UNSUPPORTED, seen.model.obstacle());
        }
        UsbTransport transport = claimed(seen.device);
        CameraDriver driver;
        try {
          driver = seen.model.driver(transport, info.id(), seen.info.serial());
        } catch (CameraProblem | RuntimeException problem) {
          transport.close();
          throw problem;
        }
        CameraLink link = new CameraLink(driver, transport, options);
        return new UsbCamera(
            driver,
            link,
            options,
            () -> findAgain(seen.model, info.id()),
            new SearchSchedule(bus.get(), pace));
      }
    }
    throw new CameraProblem(Kind.GONE, "the camera " + info.id() + " is not plugged in");
  }

  private Optional<UsbTransport> findAgain(CameraModel model, String id) throws CameraProblem {
    for (Seen seen : seen(List.of(model))) {
      if (seen.info.id().equals(id)) {
        return Optional.of(claimed(seen.device));
      }
    }
    return Optional.empty();
  }

  private UsbTransport claimed(UsbDevice device) throws CameraProblem {
    UsbTransport transport = bus.get().open(device);
    try {
      transport.claim();
      return transport;
    } catch (CameraProblem | RuntimeException problem) {
      transport.close();
      throw problem;
    }
  }

  private record Seen(UsbDevice device, CameraModel model, CameraInfo info) {}

  private List<Seen> seen() throws CameraProblem {
    return seen(models);
  }

  private List<Seen> seen(List<CameraModel> wanted) throws CameraProblem {
    List<Seen> all = new ArrayList<>();
    for (UsbDevice device : bus.get().devices()) {
      for (CameraModel model : wanted) {
        if (model.matches(device)) {
          all.add(look(device, model, all));
          break;
        }
      }
    }
    return all;
  }

  /** Opens a device briefly to read its identity and to check access. */
  private Seen look(UsbDevice device, CameraModel model, List<Seen> before) {
    if (!model.obstacle().isEmpty()) {
      return seen(device, model, before, "", model.obstacle());
    }
    String serial = "";
    String obstacle = "";
    try (UsbTransport transport = bus.get().open(device)) {
      serial = transport.serialNumber();
      transport.claim();
      if (serial.isEmpty()) {
        serial = model.serial(transport);
        serials.put(device, serial);
      }
    } catch (CameraProblem problem) {
      obstacle = problem.getMessage();
      serial = serial.isEmpty() ? serials.getOrDefault(device, "") : serial;
    }
    return seen(device, model, before, serial, obstacle);
  }

  private static Seen seen(
      UsbDevice device, CameraModel model, List<Seen> before, String serial, String obstacle) {
    String plain = model.key() + ":" + (serial.isEmpty() ? device.place() : serial);
    boolean taken = before.stream().anyMatch(other -> other.info.id().equals(plain));
    // two cameras without a serial number
    String id = taken ? plain + "@" + device.place() : plain;
    boolean canOpen = obstacle.isEmpty();
    String note = canOpen ? model.remark() : obstacle;
    return new Seen(
        device,
        model,
        new CameraInfo(id, model.name(), serial, model.nominalGeometry(), canOpen, note));
  }
}
