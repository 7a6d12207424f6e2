package haltere.core.stream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReportClockTest {
  @Test
  void ratesThatDoNotDivideASecondDoNotDrift() {
    ReportClock clock = new ReportClock();
    clock.setRate(30);
    clock.skipTo(0);
    for (int k = 0; k < 100_000; k++) {
      assertEquals(Math.round(k * 1e6 / 30), clock.nextUs());
      clock.advance();
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {-1L << 60, -3_600_000_000L, -1, 0, 1, 999_999_999, 1L << 33, 1L << 60})
  void clockSkipsToTheFirstReportAtOrAfterATime(long timeUs) {
    for (double rate : new double[] {0.001, 0.3, 1, 29.97, 100, 1000, 100_000}) {
      ReportClock clock = new ReportClock();
      clock.setRate(rate);
      clock.skipTo(timeUs);
      long first = clock.nextUs();
      assertTrue(first >= timeUs && first - timeUs <= Math.ceil(1e6 / rate), rate + " Hz");
      clock.skipTo(first);
      assertEquals(first, clock.nextUs(), "the same again");
      clock.skipTo(first + 1);
      assertTrue(clock.nextUs() > first);
    }
  }

  @Test
  void reportTimesDoNotDependOnTheStart() {
    ReportClock walking = new ReportClock();
    walking.setRate(70);
    walking.skipTo(123_456);
    for (int k = 0; k < 1000; k++) {
      ReportClock jumping = new ReportClock();
      jumping.setRate(70);
      jumping.skipTo(walking.nextUs() - 3);
      assertEquals(walking.nextUs(), jumping.nextUs());
      walking.advance();
    }
  }
}
