package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.CameraProblem;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class LookoutTest {
  private static final long NEVER = TimeUnit.HOURS.toNanos(1);
  private static final long SOON = TimeUnit.MILLISECONDS.toNanos(1);

  private Runnable changed = () -> {};
  private int watches;

  private final UsbBus telling =
      new UsbBus() {
        @Override
        public Optional<Watch> watch(Runnable whenChanged) {
          changed = whenChanged;
          watches++;
          return Optional.of(() -> watches--);
        }

        @Override
        public List<UsbDevice> devices() {
          return List.of();
        }

        @Override
        public UsbTransport open(UsbDevice device) throws CameraProblem {
          throw new CameraProblem(CameraProblem.Kind.GONE, "there is none");
        }
      };

  private Lookout begun(long often, long rarely) throws InterruptedException {
    Lookout lookout = new Lookout(telling, new Lookout.Pace(often, rarely));
    lookout.begin();
    assertTrue(lookout.await(0), "the first look is at once");
    return lookout;
  }

  @Test
  void busChangeTriggersOneSearch() throws InterruptedException {
    Lookout lookout = begun(NEVER, NEVER);
    assertFalse(lookout.await(SOON));

    changed.run();

    assertTrue(lookout.await(NEVER));
    assertFalse(lookout.await(SOON));
  }

  @Test
  void searchIsRepeatedOftenAfterABusChange() throws InterruptedException {
    Lookout lookout = begun(SOON, NEVER);

    changed.run();

    for (int look = 0; look < 5; look++) {
      assertTrue(lookout.await(NEVER));
    }
  }

  @Test
  void busIsWatchedOnlyWhileTheCameraIsDisconnected() throws InterruptedException {
    Lookout lookout = begun(NEVER, NEVER);
    assertEquals(1, watches);
    lookout.end();
    assertEquals(0, watches);
    lookout.begin();
    lookout.close();
    lookout.close();
    assertEquals(0, watches);
    lookout.begin();
    assertEquals(0, watches, "it is closed");
  }

  @Test
  void closingInterruptsAWaitingSearch() throws InterruptedException {
    Lookout lookout = begun(NEVER, NEVER);
    Thread closer = new Thread(lookout::close);
    closer.start();
    assertTrue(lookout.await(NEVER));
    closer.join();
  }
}
