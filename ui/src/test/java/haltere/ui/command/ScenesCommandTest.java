package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.settings.Parameter;
import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import org.junit.jupiter.api.Test;

class ScenesCommandTest {
  @Test
  void everySceneIsListedWithDescriptionAndSettings() {
    CommandRun run = CommandRun.of("scenes");
    assertEquals(0, run.status(), run.err());
    for (SceneProvider<?> scene : Scenes.all().values()) {
      assertTrue(run.out().contains(scene.name() + "\n  " + scene.description()), run.out());
      for (Parameter parameter : scene.schema().parameters()) {
        assertTrue(run.out().contains("    " + parameter.name() + " "), parameter.name());
      }
    }
  }

  @Test
  void namedSceneIsListedAlone() {
    CommandRun run = CommandRun.of("scenes", "road");
    assertTrue(run.out().startsWith("road\n"), run.out());
    assertFalse(run.out().contains("\nfly\n"), run.out());
  }

  @Test
  void wideRangesAreListedWithoutExponents() {
    CommandRun run = CommandRun.of("scenes", "fly");
    assertTrue(run.out().contains("-9007199254740991 to 9007199254740991"), run.out());
    assertTrue(run.out().contains("0 to 4000000000000000 us"), run.out());
  }

  @Test
  void unknownSceneIsAWrongArgument() {
    CommandRun run = CommandRun.of("scenes", "unicorn");
    assertEquals(2, run.status());
    assertTrue(run.err().contains("there is no scene named unicorn; there are dots"), run.err());
  }

  @Test
  void usageOfSimulateListsTheScenes() {
    CommandRun run = CommandRun.of("simulate", "--help");
    String text = run.out().replaceAll("\\s+", " ");
    assertTrue(text.contains("dots, flight, fly, rendered-fly, road"), run.out());
  }
}
