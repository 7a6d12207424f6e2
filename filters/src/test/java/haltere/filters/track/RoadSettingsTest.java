package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsProblem;
import haltere.testing.SettingsContract;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;

class RoadSettingsTest extends SettingsContract {
  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(RoadSettings.class);
  }

  @Test
  void aRoadThatDoesNotGoAwayIsRefused() {
    VanishingPoint any = VanishingPoint.defaults();
    for (double farthest : new double[] {50, 20}) {
      SettingsProblem problem =
          assertThrows(SettingsProblem.class, () -> new RoadSettings(5, 50, farthest, any));
      assertTrue(problem.getMessage().contains("farthestM"), problem.getMessage());
    }
  }

  @Test
  void aClickChangesTheVanishingPointOnly() {
    RoadSettings before = new RoadSettings(6, 3, 200, VanishingPoint.defaults());
    assertEquals(
        new RoadSettings(6, 3, 200, new VanishingPoint(true, 40, 90)),
        before.withVanishingPoint(VanishingPoint.at(40, 90)));
  }
}
