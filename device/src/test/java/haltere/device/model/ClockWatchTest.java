package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.camera.ClockRelation;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class ClockWatchTest {
  private final ClockWatch clock = new ClockWatch();

  @Test
  void relationIsThatOfTheShortestDelayOfTheLastSeconds() {
    note(1_000_000, 1_003);
    note(2_000_000, 2_001);
    note(3_000_000, 3_002);

    assertEquals(Optional.of(at(2_000_000, 2_001)), clock.relation());
  }

  @Test
  void relationRemainsWhileACameraSendsBuffersWithoutEvents() {
    note(1_000_000, 1_001);
    for (int ms = 2_000; ms < 60_000; ms += 100) {
      note(1_000_000, ms);
    }

    assertEquals(Optional.of(at(1_000_000, 1_001)), clock.relation());
  }

  @Test
  void relationAfterARestartIsThatOfTheNewClock() {
    note(0, 1_001);
    clock.restart();
    note(0, 5_001);

    assertEquals(Optional.of(at(0, 5_001)), clock.relation());
  }

  private void note(long cameraUs, long ms) {
    clock.note(cameraUs, TimeUnit.MILLISECONDS.toNanos(ms));
  }

  private static ClockRelation at(long cameraUs, long ms) {
    return new ClockRelation(cameraUs, TimeUnit.MILLISECONDS.toNanos(ms));
  }
}
