package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class LaneSettingsTest {
  private final LaneSettings lanes = new LaneSettings(4, -7, 3.5);

  @Test
  void theNearestMiddleIsThatOfTheLaneThatAPlaceIsIn() {
    for (double x = -6.9; x < 7; x += 0.2) {
      assertEquals(-7 + (lanes.laneAt(x) + 0.5) * 3.5, lanes.nearestMiddleM(x), 1e-12);
    }
  }

  @Test
  void besideAllLanesItIsThatOfTheOutermostOne() {
    assertEquals(LaneSettings.BESIDE, lanes.laneAt(-20));
    assertEquals(-5.25, lanes.nearestMiddleM(-20), 1e-12);
    assertEquals(LaneSettings.BESIDE, lanes.laneAt(20));
    assertEquals(5.25, lanes.nearestMiddleM(20), 1e-12);
  }
}
