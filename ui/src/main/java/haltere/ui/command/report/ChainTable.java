package haltere.ui.command.report;

import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.settings.SettingsSchema;
import haltere.ui.command.terminal.Quantities;
import java.util.ArrayList;
import java.util.List;

/** Rows of a table of a chain: its stages with the settings that differ from their defaults. */
final class ChainTable {
  static final List<String> HEADER =
      List.of("stage", "", "settings that differ", "events in", "events out", "ns/event");

  private ChainTable() {}

  /** A row for each stage, those of a nested chain after it. */
  static List<List<String>> rows(FilterChain chain) {
    List<List<String>> rows = new ArrayList<>();
    add(chain, "", rows);
    return rows;
  }

  private static void add(FilterChain chain, String prefix, List<List<String>> rows) {
    for (ChainStage stage : chain.stages()) {
      List<String> settings =
          stage.filter() instanceof ConfigurableFilter<?> filter
              ? differing(filter.settings())
              : List.of();
      rows.add(
          List.of(
              prefix + stage.name(),
              stage.isEnabled() ? "on" : "off",
              settings.isEmpty() ? "defaults" : String.join("\n", settings),
              Quantities.count(stage.timing().eventsIn()),
              Quantities.count(stage.timing().eventsOut()),
              Quantities.text("%.1f", stage.timing().microsPerThousandEvents())));
      if (stage.filter() instanceof FilterChain nested) {
        add(nested, prefix + stage.name() + " / ", rows);
      }
    }
  }

  /** Settings that differ from their defaults, a line each. */
  @SuppressWarnings("unchecked")
  static <S extends Record> List<String> differing(S settings) {
    SettingsSchema<S> schema = SettingsSchema.of((Class<S>) settings.getClass());
    return schema.changed(settings).stream()
        .map(
            name -> {
              Object usual = schema.parameter(name).defaultValue();
              return name + " = " + schema.get(settings, name) + " (default " + usual + ")";
            })
        .toList();
  }
}
