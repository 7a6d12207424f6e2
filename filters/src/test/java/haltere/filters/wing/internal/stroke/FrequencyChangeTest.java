package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class FrequencyChangeTest {
  private static final double DT_S = 1e-3;
  private static final double OMEGA = 2 * Math.PI * 200;
  private final FrequencyChange[] wings = {new FrequencyChange(), new FrequencyChange()};
  private final FrequencyHistory[] histories = {new FrequencyHistory(), new FrequencyHistory()};
  private final StrokeEkf filter = new StrokeEkf(3);

  private FrequencyChangeTest() {
    double[] state = new double[filter.size];
    double[] sd = new double[filter.size];
    sd[StrokeEkf.OMEGA] = 1;
    filter.launch(state, sd);
  }

  private void look(double left, double right) {
    double[] both = {left, right};
    for (int side = 0; side < 2; side++) {
      filter.x[StrokeEkf.OMEGA] = both[side];
      histories[side].add(DT_S, filter);
      wings[side].update(histories[side], true, wings[1 - side]);
    }
  }

  private void flySteadily() {
    Random random = new Random(1);
    for (int i = 0; i < 300; i++) {
      look(OMEGA + 0.3 * random.nextGaussian(), OMEGA + 0.3 * random.nextGaussian());
    }
    for (int i = 0; i < 10; i++) {
      look(OMEGA, OMEGA);
    }
  }

  @Test
  void commonFrequencyChangesYieldTheirSquareAsExcess() {
    flySteadily();
    look(OMEGA + 8, OMEGA + 8);
    assertEquals(64, wings[1].excess, 2);
  }

  @Test
  void usualInnovationsGiveNoExcess() {
    flySteadily();
    assertEquals(0, wings[1].excess);
    look(OMEGA + 0.2, OMEGA + 0.2);
    assertEquals(0, wings[1].excess);
  }

  @Test
  void oppositeChangesOfBothWingsAreNoise() {
    flySteadily();
    look(OMEGA + 8, OMEGA - 8);
    assertEquals(0, wings[1].excess);
  }

  @Test
  void constantFrequencyEndsAChange() {
    flySteadily();
    for (int i = 0; i < 6; i++) {
      look(OMEGA + 8, OMEGA + 8);
    }
    assertTrue(wings[1].excess > 50);
    look(OMEGA + 8, OMEGA + 8);
    look(OMEGA + 8, OMEGA + 8);
    assertEquals(0, wings[1].excess);
  }
}
