package haltere.ui.command;

import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists the filters and their settings. */
@Command(
    name = "filters",
    description = "List the filters with their settings: unit, range, default and meaning.")
final class FiltersCommand extends Subcommand {
  @Parameters(arity = "0..*", paramLabel = "NAME", description = "Only these filters.")
  List<String> names = List.of();

  @Option(
      names = "--json",
      description =
          "Print one JSON object: filters, each with name, description, settings and presets.")
  boolean json;

  FiltersCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() {
    try {
      names.forEach(Filters::named);
    } catch (ChainProblem problem) {
      throw wrongArguments(problem.getMessage());
    }
    SettingsListing.list(this, json ? Optional.of("filters") : Optional.empty(), this::addAll);
    return OK;
  }

  private void addAll(SettingsListing listing) {
    for (FilterProvider<?> provider : Filters.all().values()) {
      if (names.isEmpty() || names.contains(provider.name())) {
        listing.add(
            provider.name(),
            provider.description(),
            provider.schema().parameters(),
            provider.presets().keySet());
      }
    }
  }
}
