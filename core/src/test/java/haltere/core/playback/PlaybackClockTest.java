package haltere.core.playback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.testing.ManualClock;
import org.junit.jupiter.api.Test;

class PlaybackClockTest {
  private final ManualClock time = new ManualClock();
  private final PlaybackClock clock = new PlaybackClock(time, time);

  @Test
  void clockStandsUntilResumed() {
    time.advance(5_000_000);
    assertEquals(0, clock.positionUs());
    assertFalse(clock.running());
    assertEquals(Long.MAX_VALUE, clock.nanosUntil(0));
    clock.resume();
    time.advance(5_000_000);
    assertEquals(5_000, clock.positionUs());
    assertEquals(2_000_000, clock.nanosUntil(7_000));
    assertEquals(-1_000_000, clock.nanosUntil(4_000));
  }

  @Test
  void newSpeedAppliesFromNowOn() {
    clock.resume();
    time.advance(1_000_000);
    clock.setSpeed(1e-4);
    time.advance(1_000_000_000);
    assertEquals(1_100, clock.positionUs(), 1e-6);
    clock.setSpeed(100);
    time.advance(1_000_000);
    assertEquals(101_100, clock.positionUs(), 1e-6);
  }

  @Test
  void speedsFromOneTenThousandthToUnlimitedAreAccepted() {
    clock.setSpeed(Double.POSITIVE_INFINITY);
    clock.resume();
    assertEquals(0, clock.nanosUntil(1_000_000_000));
    for (double wrong : new double[] {0, -1, 9e-5, Double.NaN, Double.NEGATIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> clock.setSpeed(wrong));
    }
  }

  @Test
  void clockDoesNotDriftOverADayAtAnUnevenSpeed() {
    clock.setSpeed(0.3);
    clock.resume();
    long day = 86_400_000_000_000L;
    for (int i = 0; i < 86_400; i++) {
      time.advance(1_000_000_000);
      clock.nanosUntil(i);
    }
    assertEquals(day / 1000 * 0.3, clock.positionUs(), 1);
  }

  @Test
  void jumpsDelaysAndShiftsChangeDueTimes() {
    clock.resume();
    time.advance(1_000_000);
    clock.setPosition(50_000);
    assertEquals(0, clock.nanosUntil(50_000));
    clock.delay(3_000);
    assertEquals(3_000, clock.nanosUntil(50_000));
    clock.shift(-50_000);
    assertEquals(3_000, clock.nanosUntil(0));
  }
}
