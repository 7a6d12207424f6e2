package haltere.ui.command;

import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import java.util.Set;
import picocli.CommandLine.Command;

/** Lists the scenes that can be simulated and their settings. */
@Command(
    name = "scenes",
    description =
        "List the scenes that can be simulated with their settings: unit, range, default and"
            + " meaning.")
final class ScenesCommand extends SettingsListing {
  @Override
  Set<String> all() {
    return Scenes.all().keySet();
  }

  @Override
  Entry entry(String name) {
    SceneProvider<?> provider = Scenes.named(name);
    return new Entry(provider.description(), provider.schema().parameters(), Set.of());
  }
}
