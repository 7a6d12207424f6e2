package haltere.filters.noise.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import org.junit.jupiter.api.Test;

class PolarityRunsTest {
  private static final int OFF = EventAddress.pack(4, 8, 0);
  private static final int ON = EventAddress.pack(4, 8, 1);

  private final PolarityRuns runs = new PolarityRuns(new SensorGeometry(16, 16));

  private void off(long... timesUs) {
    for (long timeUs : timesUs) {
      runs.begins(timeUs, OFF);
    }
  }

  private void on(long... timesUs) {
    for (long timeUs : timesUs) {
      runs.begins(timeUs, ON);
    }
  }

  @Test
  void firstEventOfARunStartsIt() {
    assertTrue(runs.begins(1000, OFF));
    assertFalse(runs.begins(1010, OFF));
    assertTrue(runs.begins(1100, ON));
    assertFalse(runs.begins(1110, ON));
    assertTrue(runs.begins(4000, ON), "a run that is too long");
  }

  @Test
  void uniformShadowResolvesNoVein() {
    off(1000, 1010, 1020);
    on(1200, 1210, 1220);
    assertFalse(runs.hasPassed());
    off(3500);
    assertTrue(runs.hasPassed());
    assertEquals(0, runs.resolvedUs());
    off(3510);
    assertFalse(runs.hasPassed(), "it is told once");
  }

  @Test
  void leavingVeinsPrecedeTheTrailingEdge() {
    off(1000, 1010);
    on(1040, 1050, 1300);
    off(3500);
    assertTrue(runs.hasPassed());
    assertEquals(250, runs.resolvedUs());
  }

  @Test
  void secondVeinBelongsToTheSamePassage() {
    off(1000, 1010);
    on(1040);
    off(1100, 1110);
    assertFalse(runs.hasPassed());
    on(1140, 1300);
    off(3500);
    assertTrue(runs.hasPassed());
    assertEquals(250, runs.resolvedUs());
  }

  @Test
  void passagesWithoutATrailingEdgeAreIgnored() {
    off(1000);
    on(1040);
    off(1100);
    off(4000);
    assertFalse(runs.hasPassed());
    on(4040);
    runs.clear();
    off(6500);
    assertFalse(runs.hasPassed());
  }

  @Test
  void oneOfSixteenPixelsReportsPassages() {
    for (int x = 0; x < 8; x++) {
      runs.begins(1000, EventAddress.pack(x, 0, 0));
      runs.begins(1200, EventAddress.pack(x, 0, 1));
      runs.begins(3500, EventAddress.pack(x, 0, 0));
      assertEquals(x % 4 == 0, runs.hasPassed());
    }
  }

  @Test
  void pixelsInTheLastRowAndColumnHaveSeparatePassages() {
    PolarityRuns odd = new PolarityRuns(new SensorGeometry(17, 13));
    for (int i = 0; i < 3; i++) {
      int on = 1200 + 10 * i;
      for (int x = 0; x < 17; x += 4) {
        odd.begins(1000 + i, EventAddress.pack(x, 4 * i, 0));
        odd.begins(on, EventAddress.pack(x, 4 * i, 1));
        odd.begins(on + x, EventAddress.pack(x, 4 * i, 1));
      }
    }
    odd.begins(1000, EventAddress.pack(16, 12, 0));
    odd.begins(1200, EventAddress.pack(16, 12, 1));
    odd.begins(3500, EventAddress.pack(16, 12, 0));
    assertTrue(odd.hasPassed());
    assertEquals(0, odd.resolvedUs());
    for (int x = 0; x < 17; x += 4) {
      odd.begins(3600, EventAddress.pack(x, 8, 0));
      assertTrue(odd.hasPassed());
      assertEquals(x, odd.resolvedUs());
    }
  }
}
