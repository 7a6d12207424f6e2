package haltere.ui.command;

import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
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

  @Option(
      names = "--json",
      description =
          "Print one JSON object: scenes, each with name, description, settings and presets.")
  boolean json;

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
    SettingsListing.list(this, json ? Optional.of("scenes") : Optional.empty(), this::addAll);
    return OK;
  }

  private void addAll(SettingsListing listing) {
    for (SceneProvider<?> provider : Scenes.all().values()) {
      if (names.isEmpty() || names.contains(provider.name())) {
        listing.add(
            provider.name(), provider.description(), provider.schema().parameters(), Set.of());
      }
    }
  }
}
