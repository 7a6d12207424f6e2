package haltere.filters.plane;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsProblem;
import haltere.testing.SettingsContract;
import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;

class RoadViewSettingsTest extends SettingsContract {
  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(RoadViewSettings.class);
  }

  @Test
  void roadsThatDoNotRecedeAreRejected() {
    VanishingPoint any = VanishingPoint.defaults();
    for (double farthest : new double[] {50, 20}) {
      SettingsProblem problem =
          assertThrows(SettingsProblem.class, () -> new RoadViewSettings(5, 50, farthest, any));
      assertTrue(problem.getMessage().contains("farthestM"), problem.getMessage());
    }
  }
}
