package haltere.filters.wing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class StrokeMemoryTest {
  private static final double OVER_S = 40e-6;
  private static final int SECOND = StrokeEkf.SERIES + 1;
  private static final int THIRD = StrokeEkf.SERIES + 3;

  /** Forgets for a second that the second and third harmonics are 0.1 radians. */
  private static StrokeEkf after(double slow) {
    StrokeEkf filter = new StrokeEkf(3);
    double[] state = new double[filter.size];
    state[SECOND] = 0.1;
    state[THIRD] = 0.1;
    filter.launch(state, new double[filter.size]);
    for (int i = 0; i < 1000; i++) {
      StrokeMemory.forget(filter, 1e-3, 100, slow);
    }
    return filter;
  }

  @Test
  void pixelsThatAnswerInMidStrokeShowTheWholeStroke() {
    assertEquals(0, StrokeMemory.reversalsAlone(-5e-6, OVER_S));
    assertTrue(StrokeMemory.reversalsAlone(100e-6, OVER_S) < 0.001);
    assertTrue(StrokeMemory.reversalsAlone(700e-6, OVER_S) > 0.95);
  }

  @Test
  void whatReversalsAloneDoNotTellIsSoonForgotten() {
    assertEquals(0.1 / Math.E, after(0).x[THIRD], 1e-6);
    assertTrue(Math.abs(after(1).x[THIRD]) < 1e-4);
    assertTrue(after(1).sd(THIRD) < 0.2 * after(0).sd(THIRD));
  }

  @Test
  void theSecondHarmonicIsToldByReversalsAsWell() {
    assertEquals(after(0).x[SECOND], after(1).x[SECOND], 1e-12);
    assertEquals(after(0).sd(SECOND), after(1).sd(SECOND), 1e-12);
  }
}
