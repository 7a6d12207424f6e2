package haltere.filters.orientation;

import haltere.testing.SettingsContract;
import java.util.Collection;
import java.util.List;

/** Contract of settings that belong to no filter of the chain. */
class OrientationSettingsTest extends SettingsContract {
  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(OrientationSettings.class);
  }
}
