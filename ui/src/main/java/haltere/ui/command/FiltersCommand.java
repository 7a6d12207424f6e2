package haltere.ui.command;

import haltere.core.chain.Filters;
import picocli.CommandLine.Command;

/** Lists the filters and their settings. */
@Command(
    name = "filters",
    description = "List the filters with their settings: unit, range, default and meaning.")
final class FiltersCommand extends SettingsListing {
  FiltersCommand() {
    super(Filters::all, Filters::named);
  }
}
