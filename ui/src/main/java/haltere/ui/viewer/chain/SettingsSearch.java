package haltere.ui.viewer.chain;

import haltere.core.settings.Parameter;
import haltere.ui.viewer.controls.Texts;
import java.util.Locale;

/**
 * Which settings are to be seen.
 *
 * @param words in a setting's name or help, lower case; empty for all
 * @param changedOnly whether only those are wanted that are not at their default
 */
record SettingsSearch(String words, boolean changedOnly) {
  /** Nothing is searched for. */
  static final SettingsSearch ALL = new SettingsSearch("", false);

  /** Whether it leaves anything out. */
  boolean isActive() {
    return changedOnly || !words.isEmpty();
  }

  boolean matches(Parameter parameter, boolean changed) {
    String searched =
        (Texts.label(parameter) + " " + parameter.group() + " " + parameter.help())
            .toLowerCase(Locale.ROOT);
    return (!changedOnly || changed) && searched.contains(words);
  }
}
