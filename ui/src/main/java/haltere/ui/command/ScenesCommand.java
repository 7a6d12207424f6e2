package haltere.ui.command;

import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Lists the scenes that can be simulated and their settings. */
@Command(
    name = "scenes",
    description =
        "List the scenes that can be simulated with their settings: unit, range, default and"
            + " meaning.")
final class ScenesCommand extends Subcommand {
  @Parameters(arity = "0..*", paramLabel = "NAME", description = "Only these scenes.")
  List<String> names = List.of();

  ScenesCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() {
    try {
      names.forEach(Scenes::named);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments(problem.getMessage());
    }
    SettingsListing listing = new SettingsListing(this::result);
    for (SceneProvider<?> provider : Scenes.all().values()) {
      if (names.isEmpty() || names.contains(provider.name())) {
        listing.add(provider.name(), provider.description(), provider.schema().parameters());
      }
    }
    return OK;
  }
}
