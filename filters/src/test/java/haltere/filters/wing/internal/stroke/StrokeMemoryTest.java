package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class StrokeMemoryTest {
  @Test
  void unobservedParametersReturnToTheirPriors() {
    StrokeEkf filter = new StrokeEkf(4);
    double[] state = new double[filter.size];
    state[StrokeEkf.AMPLITUDE] = 1.1;
    state[StrokeEkf.WIDTH] = 0.1;
    state[StrokeEkf.SERIES + 1] = 0.1;
    state[StrokeEkf.SERIES + 5] = 0.05;
    filter.launch(state, new double[filter.size]);
    double[] q = new double[filter.size];
    StrokeMemory.setDensities(q, 100);
    for (int i = 0; i < 1000; i++) {
      StrokeMemory.forget(filter, 1e-3, q, true);
    }
    double kept = 1 / Math.E;
    assertEquals(1.1, filter.x[StrokeEkf.AMPLITUDE], "what every event shows is not forgotten");
    assertEquals(0.025 + kept * 0.075, filter.x[StrokeEkf.WIDTH], 1e-6);
    assertEquals(kept * 0.1, filter.x[StrokeEkf.SERIES + 1], 1e-6);
    assertEquals(kept * 0.05, filter.x[StrokeEkf.SERIES + 5], 1e-6);
    assertEquals(0.012 * Math.sqrt(1 - kept * kept), filter.belief.sd(StrokeEkf.SERIES + 5), 1e-6);
  }

  @Test
  void widthAndLagStayWhileOnlyOneEdgeHasEvents() {
    StrokeEkf filter = new StrokeEkf(2);
    double[] state = new double[filter.size];
    state[StrokeEkf.WIDTH] = 0.1;
    state[StrokeEkf.LAG] = 300e-6;
    double[] sd = new double[filter.size];
    Arrays.fill(sd, 0.01);
    filter.launch(state, sd);
    double[] q = new double[filter.size];
    StrokeMemory.setDensities(q, 100);
    StrokeMemory.forget(filter, 0.5, q, false);
    assertEquals(0.1, filter.x[StrokeEkf.WIDTH]);
    assertEquals(300e-6, filter.x[StrokeEkf.LAG]);
    assertEquals(0, filter.belief.sd(StrokeEkf.WIDTH));
    assertEquals(0, filter.belief.sd(StrokeEkf.LAG));
  }
}
