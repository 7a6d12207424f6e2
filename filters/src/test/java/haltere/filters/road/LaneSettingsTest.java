package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.testing.SettingsContract;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;

class LaneSettingsTest extends SettingsContract {
  private final LaneSettings lanes = new LaneSettings(4, -7, 3.5);

  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(LaneSettings.class, CountingLineSettings.class);
  }

  @Test
  void lanesAreNumberedFromTheLeft() {
    assertEquals(0, lanes.laneAt(-7));
    assertEquals(1, lanes.laneAt(-0.01));
    assertEquals(2, lanes.laneAt(0));
    assertEquals(3, lanes.laneAt(6.99));
  }

  @Test
  void positionsOutsideTheLanesHaveNoLane() {
    assertEquals(LaneSettings.BESIDE, lanes.laneAt(-7.01));
    assertEquals(LaneSettings.BESIDE, lanes.laneAt(7));
    assertEquals(LaneSettings.BESIDE, lanes.laneAt(Double.NaN));
    assertEquals(LaneSettings.BESIDE, LaneSettings.defaults().laneAt(0));
  }
}
