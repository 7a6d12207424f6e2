package haltere.testing.usb;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.device.usb.OpeningHelp;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * A bus in memory: the same devices as those of {@link UsbEmulator}, without libusb, so on every
 * system.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class MemoryBus implements UsbBus, TestBus {
  private final Map<UsbDevice, EmulatedDevice> plugged = new ConcurrentHashMap<>();
  private final List<Watching> watching = new CopyOnWriteArrayList<>();

  private final class Watching implements Watch {
    private final Runnable changed;

    Watching(Runnable changed) {
      this.changed = changed;
    }

    @Override
    public void close() {
      watching.remove(this);
    }
  }

  @Override
  public UsbBus bus() {
    return this;
  }

  @Override
  public EmulatedDevice plug(int number, Firmware firmware) {
    EmulatedDevice device = new EmulatedDevice(number, firmware);
    byte[] descriptor = firmware.deviceDescriptor();
    UsbDevice seen =
        new UsbDevice(word(descriptor, 8), word(descriptor, 10), word(descriptor, 12), 1, number);
    device.onUnplug(
        () -> {
          plugged.remove(seen);
          device.endAll();
          tell();
        });
    firmware.attached(device);
    plugged.put(seen, device);
    tell();
    return device;
  }

  private void tell() {
    watching.forEach(each -> each.changed.run());
  }

  @Override
  public Optional<Watch> watch(Runnable changed) {
    Watching fresh = new Watching(changed);
    watching.add(fresh);
    return Optional.of(fresh);
  }

  private static int word(byte[] bytes, int at) {
    return bytes[at] & 0xff | (bytes[at + 1] & 0xff) << 8;
  }

  @Override
  public List<UsbDevice> devices() {
    return plugged.keySet().stream().sorted(Comparator.comparingInt(UsbDevice::address)).toList();
  }

  @Override
  public UsbTransport open(UsbDevice device) throws CameraProblem {
    EmulatedDevice emulated = plugged.get(device);
    if (emulated == null) {
      throw new CameraProblem(
          Kind.GONE, "no device is plugged in at " + device.place() + " any more");
    }
    if (emulated.isForbidden()) {
      throw new CameraProblem(Kind.NOT_PERMITTED, OpeningHelp.forbidden(device, "Linux"));
    }
    return new MemoryTransport(device, emulated);
  }

  @Override
  public void close() {
    plugged.values().forEach(EmulatedDevice::unplug);
  }
}
