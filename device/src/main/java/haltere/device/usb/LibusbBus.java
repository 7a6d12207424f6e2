package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.usb4java.Context;
import org.usb4java.Device;
import org.usb4java.DeviceDescriptor;
import org.usb4java.DeviceHandle;
import org.usb4java.DeviceList;
import org.usb4java.LibUsb;

/**
 * USB through libusb, which usb4java contains. One context for the whole program; while a device is
 * open or there is a subscription, a thread handles its events.
 */
public final class LibusbBus implements UsbBus {
  private static final class Found {
    static final LibusbBus SHARED = new LibusbBus();
  }

  private Context context;
  private LibusbEvents events;
  private LibusbChanges changes;

  private LibusbBus() {}

  /**
   * The bus of this program.
   *
   * @return the same at every call
   */
  public static LibusbBus shared() {
    return Found.SHARED;
  }

  @Override
  public Optional<Watch> watch(Runnable changed) throws CameraProblem {
    context();
    return changes.watch(changed);
  }

  @Override
  public List<UsbDevice> devices() throws CameraProblem {
    Context started = context();
    List<UsbDevice> found = new ArrayList<>();
    DeviceList all = new DeviceList();
    LibusbProblem.check(LibUsb.getDeviceList(started, all), "list the devices on USB");
    try {
      for (Device device : all) {
        UsbDevice seen = describe(device);
        if (seen != null) {
          found.add(seen);
        }
      }
    } finally {
      LibUsb.freeDeviceList(all, true);
    }
    found.sort(Comparator.comparingInt(UsbDevice::bus).thenComparingInt(UsbDevice::address));
    return found;
  }

  /** Properties of a device without opening it, or null. */
  private static UsbDevice describe(Device device) {
    DeviceDescriptor descriptor = new DeviceDescriptor();
    if (LibUsb.getDeviceDescriptor(device, descriptor) != LibUsb.SUCCESS) {
      return null;
    }
    return new UsbDevice(
        Short.toUnsignedInt(descriptor.idVendor()),
        Short.toUnsignedInt(descriptor.idProduct()),
        Short.toUnsignedInt(descriptor.bcdDevice()),
        LibUsb.getBusNumber(device),
        LibUsb.getDeviceAddress(device));
  }

  @Override
  public UsbTransport open(UsbDevice device) throws CameraProblem {
    Context started = context();
    DeviceList all = new DeviceList();
    LibusbProblem.check(LibUsb.getDeviceList(started, all), "list the devices on USB");
    try {
      for (Device candidate : all) {
        if (device.equals(describe(candidate))) {
          return open(device, candidate);
        }
      }
    } finally {
      LibUsb.freeDeviceList(all, true);
    }
    throw new CameraProblem(
        Kind.GONE, "no device is plugged in at " + device.place() + " any more");
  }

  private UsbTransport open(UsbDevice device, Device candidate) throws CameraProblem {
    DeviceHandle handle = new DeviceHandle();
    int result = LibUsb.open(candidate, handle);
    String system = System.getProperty("os.name");
    switch (result) {
      case LibUsb.SUCCESS -> {}
      case LibUsb.ERROR_ACCESS ->
          throw new CameraProblem(Kind.NOT_PERMITTED, OpeningHelp.forbidden(device, system));
      case LibUsb.ERROR_NOT_SUPPORTED, LibUsb.ERROR_NOT_FOUND ->
          throw new CameraProblem(Kind.UNSUPPORTED, OpeningHelp.withoutDriver(system));
      default -> LibusbProblem.check(result, "open the device at " + device.place());
    }
    DeviceDescriptor descriptor = new DeviceDescriptor();
    int serialIndex =
        LibUsb.getDeviceDescriptor(candidate, descriptor) == LibUsb.SUCCESS
            ? descriptor.iSerialNumber()
            : 0;
    return new LibusbTransport(device, handle, serialIndex, events);
  }

  /** The first cause: a class that could not be initialised names none in its own message. */
  private static Throwable cause(Throwable failure) {
    return failure.getCause() == null ? failure : cause(failure.getCause());
  }

  private synchronized Context context() throws CameraProblem {
    if (context == null) {
      Context fresh = new Context();
      try {
        LibusbProblem.check(LibUsb.init(fresh), "start libusb");
        LibusbFiles.remove();
      } catch (LinkageError | RuntimeException noNative) {
        throw new CameraProblem(
            Kind.UNSUPPORTED,
            "USB cannot be used here, libusb was not found for "
                + System.getProperty("os.name")
                + " on "
                + System.getProperty("os.arch")
                + ": "
                + cause(noNative).getMessage());
      }
      context = fresh;
      events = new LibusbEvents(fresh);
      changes = new LibusbChanges(fresh, events);
    }
    return context;
  }
}
