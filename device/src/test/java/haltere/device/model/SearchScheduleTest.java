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
class SearchScheduleTest {
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

  private SearchSchedule begun(long often, long rarely) throws InterruptedException {
    SearchSchedule schedule = new SearchSchedule(telling, new SearchSchedule.Pace(often, rarely));
    schedule.begin();
    assertTrue(schedule.await(0), "the first look is at once");
    return schedule;
  }

  @Test
  void busChangeTriggersOneSearch() throws InterruptedException {
    SearchSchedule schedule = begun(NEVER, NEVER);
    assertFalse(schedule.await(SOON));

    changed.run();

    assertTrue(schedule.await(NEVER));
    assertFalse(schedule.await(SOON));
  }

  @Test
  void searchIsRepeatedOftenAfterABusChange() throws InterruptedException {
    SearchSchedule schedule = begun(SOON, NEVER);

    changed.run();

    for (int look = 0; look < 5; look++) {
      assertTrue(schedule.await(NEVER));
    }
  }

  @Test
  void busIsWatchedOnlyWhileTheCameraIsDisconnected() throws InterruptedException {
    SearchSchedule schedule = begun(NEVER, NEVER);
    assertEquals(1, watches);
    schedule.end();
    assertEquals(0, watches);
    schedule.begin();
    schedule.close();
    schedule.close();
    assertEquals(0, watches);
    schedule.begin();
    assertEquals(0, watches, "it is closed");
  }

  @Test
  void closingInterruptsAWaitingSearch() throws InterruptedException {
    SearchSchedule schedule = begun(NEVER, NEVER);
    Thread closer = new Thread(schedule::close);
    closer.start();
    assertTrue(schedule.await(NEVER));
    closer.join();
  }
}
