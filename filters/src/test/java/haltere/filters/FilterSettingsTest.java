package haltere.filters;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.testing.SettingsContract;
import java.util.Collection;

class FilterSettingsTest extends SettingsContract {
  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return Filters.all().values().stream().map(FilterSettingsTest::settingsType).toList();
  }

  private static Class<? extends Record> settingsType(FilterProvider<?> provider) {
    return provider.settingsType();
  }
}
