package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class LabelVelocitiesTest {
  private static final double SPEED_PX_S = 120;

  @Test
  void steadyMotionHasItsVelocityBetweenTheFirstAndTheLastLabel() {
    List<TruthMoment> known =
        LabelVelocities.of(moments(20_000, 10, s -> SPEED_PX_S * s, s -> -SPEED_PX_S * s / 3));
    for (TruthMoment moment : known.subList(1, known.size() - 1)) {
      assertEquals(SPEED_PX_S, moment.objects().get(0).vxPxS(), 1e-9);
      assertEquals(-SPEED_PX_S / 3, moment.objects().get(0).vyPxS(), 1e-9);
    }
    assertTrue(Double.isNaN(known.get(0).objects().get(0).vxPxS()));
    assertTrue(Double.isNaN(known.get(known.size() - 1).objects().get(0).vxPxS()));
  }

  @Test
  void rareLabelsGiveTheVelocityBetweenTheirNeighbours() {
    List<TruthMoment> known = LabelVelocities.of(moments(150_000, 3, s -> SPEED_PX_S * s, s -> 0));
    assertEquals(SPEED_PX_S, known.get(1).objects().get(0).vxPxS(), 1e-9);
  }

  @Test
  void labelsFarApartSayNothingAboutTheVelocity() {
    List<TruthMoment> known = LabelVelocities.of(moments(250_000, 3, s -> SPEED_PX_S * s, s -> 0));
    assertTrue(Double.isNaN(known.get(1).objects().get(0).vxPxS()));
  }

  @Test
  void pendulumHasItsVelocityWithinAFewPercent() {
    double perS = 2 * Math.PI / 1.2;
    List<TruthMoment> known =
        LabelVelocities.of(moments(20_000, 120, s -> 50 + 30 * Math.sin(perS * s), s -> 0));
    for (TruthMoment moment : known.subList(3, known.size() - 3)) {
      double truth = 30 * perS * Math.cos(perS * moment.timeUs() * 1e-6);
      assertEquals(truth, moment.objects().get(0).vxPxS(), 0.03 * 30 * perS);
    }
  }

  @Test
  void knownVelocityStays() {
    TrueObject object = new TrueObject(1, new Box(0, 0, 4, 4), 7, 8);
    List<TruthMoment> moments = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      moments.add(new TruthMoment(20_000L * i, List.of(object), List.of()));
    }
    assertEquals(moments, LabelVelocities.of(moments));
  }

  private static List<TruthMoment> moments(
      long stepUs, int count, DoubleUnaryOperator x, DoubleUnaryOperator y) {
    List<TruthMoment> moments = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double s = i * stepUs * 1e-6;
      double left = x.applyAsDouble(s);
      double low = y.applyAsDouble(s);
      TrueObject object = new TrueObject(1, new Box(left, low, left + 8, low + 6));
      moments.add(new TruthMoment(i * stepUs, List.of(object), List.of()));
    }
    return moments;
  }
}
