package haltere.ui.viewer.chain;

import haltere.core.settings.Parameter;
import haltere.ui.viewer.controls.Texts;
import java.util.Locale;

/**
 * Search criteria for settings.
 *
 * @param text in a setting's name or help, lower case; empty for all
 * @param changedOnly whether only settings that differ from their defaults match
 */
record SettingsSearch(String text, boolean changedOnly) {
  /** Nothing is searched for. */
  static final SettingsSearch ALL = new SettingsSearch("", false);

  /** Whether it leaves anything out. */
  boolean isActive() {
    return changedOnly || !text.isEmpty();
  }

  boolean matches(Parameter parameter, boolean changed) {
    String searched =
        (Texts.label(parameter) + " " + parameter.group() + " " + parameter.help())
            .toLowerCase(Locale.ROOT);
    return (!changedOnly || changed) && searched.contains(text);
  }
}
