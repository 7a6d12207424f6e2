package haltere.device.usb;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.usb4java.Context;
import org.usb4java.HotplugCallbackHandle;
import org.usb4java.LibUsb;

/**
 * Reports arrivals and removals of devices by libusb's hot-plug callbacks, where available: on
 * Linux and macOS, not on Windows. One callback for the program, which is never removed: usb4java
 * releases a removed callback while libusb may be about to call it.
 *
 * <p>Thread rule: all methods may be called from any thread; subscribers are called by an
 * event-handling thread of {@link LibusbEvents}.
 */
final class LibusbChanges {
  private static final int GO_ON = 0;

  private final Context context;
  private final LibusbEvents events;
  private final HotplugCallbackHandle handle = new HotplugCallbackHandle();
  private final List<Watching> watching = new CopyOnWriteArrayList<>();
  private boolean registered;

  LibusbChanges(Context context, LibusbEvents events) {
    this.context = context;
    this.events = events;
  }

  Optional<UsbBus.Watch> watch(Runnable changed) {
    if (!register()) {
      return Optional.empty();
    }
    Watching fresh = new Watching(changed);
    watching.add(fresh);
    events.join();
    return Optional.of(fresh);
  }

  private synchronized boolean register() {
    if (!registered && LibUsb.hasCapability(LibUsb.CAP_HAS_HOTPLUG)) {
      int result =
          LibUsb.hotplugRegisterCallback(
              context,
              LibUsb.HOTPLUG_EVENT_DEVICE_ARRIVED | LibUsb.HOTPLUG_EVENT_DEVICE_LEFT,
              LibUsb.HOTPLUG_NO_FLAGS,
              LibUsb.HOTPLUG_MATCH_ANY,
              LibUsb.HOTPLUG_MATCH_ANY,
              LibUsb.HOTPLUG_MATCH_ANY,
              (of, device, event, data) -> {
                watching.forEach(each -> each.changed.run());
                return GO_ON;
              },
              null,
              handle);
      registered = result == LibUsb.SUCCESS;
    }
    return registered;
  }

  /** A subscription; one object for each, also for equal listeners. */
  private final class Watching implements UsbBus.Watch {
    private final Runnable changed;

    Watching(Runnable changed) {
      this.changed = changed;
    }

    @Override
    public void close() {
      if (watching.remove(this)) {
        events.leave();
      }
    }
  }
}
