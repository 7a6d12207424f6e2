package haltere.ui.command;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import java.util.Set;
import picocli.CommandLine.Command;

/** Lists the filters and their settings. */
@Command(
    name = "filters",
    description = "List the filters with their settings: unit, range, default and meaning.")
final class FiltersCommand extends SettingsListing {
  @Override
  Set<String> all() {
    return Filters.all().keySet();
  }

  @Override
  Entry entry(String name) {
    FilterProvider<?> provider = Filters.named(name);
    return new Entry(
        provider.description(), provider.schema().parameters(), provider.presets().keySet());
  }
}
