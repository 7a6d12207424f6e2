package haltere.core.simulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.SettingsProblem;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.testing.ServiceFiles;
import java.util.List;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

/** The scenes are found by name. */
class ScenesTest {
  @Test
  void everySceneOfTheModuleIsRegisteredAsAService() {
    assertEquals(
        ServiceFiles.implementations(SceneProvider.class, Scenes.class),
        ServiceFiles.registered(SceneProvider.class));
  }

  @Test
  void sceneIsCreatedByNameAndChangedSettings() {
    Scene<?> scene = Scenes.named("fly").create(List.of("run.durationS=0.5", "run.startUs=7000"));

    assertEquals(FlyTruth.class, scene.truthType());
    assertEquals(OptionalLong.of(500_000), scene.durationUs());
    assertEquals(7000, scene.truthTimeUs(0));
    assertEquals(8000, scene.truthTimeUs(1));
    assertEquals(8000, ((FlyTruth) scene.truthRows(8000).get(0)).tUs());
  }

  @Test
  void unknownNamesAreRejectedWithTheListOfNames() {
    var problem = assertThrows(IllegalArgumentException.class, () -> Scenes.named("moon"));

    assertTrue(problem.getMessage().contains("moon"), problem.getMessage());
    assertTrue(problem.getMessage().contains("fly"), problem.getMessage());
  }

  @Test
  void unknownSettingsAreRejected() {
    var provider = Scenes.named("fly");

    assertThrows(SettingsProblem.class, () -> provider.create(List.of("wings=4")));
  }

  @Test
  void scenesHaveADescription() {
    for (SceneProvider<?> provider : Scenes.all().values()) {
      assertTrue(provider.description().endsWith("."), provider.name());
    }
  }
}
