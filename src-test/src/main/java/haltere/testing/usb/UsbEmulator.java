package haltere.testing.usb;

import haltere.device.usb.LibusbBus;
import haltere.device.usb.UsbBus;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * The test's half of the emulated Linux USB: writes the tree of files that libusb looks at, tells
 * of devices that come and go, and serves the sockets to which {@code libusbemu.so} (src/usbemu)
 * turns what libusb asks the kernel for. It must be there before libusb starts.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class UsbEmulator implements TestBus {
  /** Number of the usbfs ioctl that claims an interface. */
  public static final int CLAIM = 15;

  private static final String SYSFS = "sys/devices/usbemu/usb1/";
  private static final String LINKS = "sys/bus/usb/devices/";
  private static final String NODES = "dev/bus/usb/001/";

  private final Path folder;
  private final ServerSocketChannel uevents;
  private final List<SocketChannel> monitors = new CopyOnWriteArrayList<>();
  private final Map<EmulatedDevice, HostConnections> connections = new ConcurrentHashMap<>();

  /**
   * An empty bus.
   *
   * @param folder what the environment's USBEMU_DIR names: a short path, for names of sockets are
   * @throws IOException if it cannot be written to
   */
  public UsbEmulator(Path folder) throws IOException {
    this.folder = folder;
    for (String name : List.of(LINKS, SYSFS, NODES, "run/udev")) {
      Files.createDirectories(folder.resolve(name));
    }
    create(folder.resolve("run/udev/control"));
    uevents = HostConnections.listen(folder.resolve("uevent.sock"));
    uevents.configureBlocking(false);
  }

  @Override
  public UsbBus bus() {
    return LibusbBus.shared();
  }

  @Override
  public EmulatedDevice plug(int number, Firmware firmware) {
    EmulatedDevice device = new EmulatedDevice(number, firmware);
    try {
      Path sysfs = Files.createDirectories(folder.resolve(SYSFS + name(device)));
      byte[] first = firmware.deviceDescriptor();
      byte[] second = firmware.configurationDescriptor();
      ByteBuffer descriptors = ByteBuffer.allocate(first.length + second.length);
      Files.write(sysfs.resolve("descriptors"), descriptors.put(first).put(second).array());
      Files.writeString(sysfs.resolve("busnum"), "1\n");
      Files.writeString(sysfs.resolve("devnum"), number + "\n");
      Files.writeString(sysfs.resolve("speed"), "480\n");
      Files.writeString(sysfs.resolve("bConfigurationValue"), "1\n");
      Files.writeString(sysfs.resolve("uevent"), String.join("\n", properties(device)) + "\n");
      link(sysfs.resolve("subsystem"), "../../../../bus/usb");
      HostConnections host =
          new HostConnections(
              device, folder.resolve(String.format(Locale.ROOT, "001-%03d.sock", number)));
      connections.put(device, host);
      create(node(device));
      link(folder.resolve(LINKS + name(device)), "../../../devices/usbemu/usb1/" + name(device));
      device.onUnplug(() -> unplug(device));
      device.onForbidden(() -> forbid(device));
      firmware.attached(device);
      uevent("add", device);
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
    return device;
  }

  private void unplug(EmulatedDevice device) {
    try {
      Files.deleteIfExists(folder.resolve(LINKS + name(device)));
      Files.deleteIfExists(node(device));
      Files.deleteIfExists(forbiddenMark(device)); // its address may be another one's next
      connections.remove(device).close();
      uevent("remove", device);
      Path sysfs = folder.resolve(SYSFS + name(device));
      try (var files = Files.list(sysfs)) {
        for (Path file : files.toList()) {
          Files.delete(file);
        }
      }
      Files.delete(sysfs);
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  private void forbid(EmulatedDevice device) {
    Path mark = folder.resolve(String.format(Locale.ROOT, "001-%03d.forbidden", device.number()));
    try {
      Files.deleteIfExists(mark);
      if (device.isForbidden()) {
        Files.createFile(mark);
      }
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  private Path forbiddenMark(EmulatedDevice device) {
    return folder.resolve(String.format(Locale.ROOT, "001-%03d.forbidden", device.number()));
  }

  private static String name(EmulatedDevice device) {
    return "1-" + device.number();
  }

  private Path node(EmulatedDevice device) {
    return folder.resolve(String.format(Locale.ROOT, "%s%03d", NODES, device.number()));
  }

  private static List<String> properties(EmulatedDevice device) {
    int number = device.number();
    return List.of(
        "MAJOR=189",
        "MINOR=" + (number - 1),
        String.format(Locale.ROOT, "DEVNAME=bus/usb/001/%03d", number),
        "DEVTYPE=usb_device",
        "DRIVER=usb",
        "BUSNUM=001",
        String.format(Locale.ROOT, "DEVNUM=%03d", number));
  }

  /** Tells all monitors, also one that has connected just now: the kernel does not forget it. */
  private synchronized void uevent(String action, EmulatedDevice device) throws IOException {
    for (SocketChannel monitor = uevents.accept(); monitor != null; monitor = uevents.accept()) {
      monitors.add(monitor);
    }
    String path = "/devices/usbemu/usb1/" + name(device);
    StringBuilder text = new StringBuilder();
    text.append(action).append('@').append(path).append('\0');
    text.append("ACTION=").append(action).append('\0');
    text.append("DEVPATH=").append(path).append('\0');
    text.append("SUBSYSTEM=usb\0");
    properties(device).forEach(property -> text.append(property).append('\0'));
    text.append("SEQNUM=1\0");
    byte[] body = text.toString().getBytes(StandardCharsets.US_ASCII);
    ByteBuffer message =
        ByteBuffer.allocate(Integer.BYTES + body.length)
            .order(ByteOrder.nativeOrder())
            .putInt(body.length)
            .put(body);
    for (SocketChannel monitor : monitors) {
      try {
        HostConnections.write(monitor, message.duplicate().flip());
      } catch (IOException gone) {
        monitors.remove(monitor);
      }
    }
  }

  private static void create(Path file) throws IOException {
    if (!Files.exists(file)) {
      Files.createFile(file);
    }
  }

  private static void link(Path from, String to) throws IOException {
    Files.deleteIfExists(from);
    Files.createSymbolicLink(from, Path.of(to));
  }

  @Override
  public void close() {
    List.copyOf(connections.keySet()).forEach(EmulatedDevice::unplug);
    try {
      uevents.close();
      for (SocketChannel monitor : monitors) {
        monitor.close();
      }
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }
}
