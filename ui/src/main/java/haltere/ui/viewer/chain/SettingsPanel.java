package haltere.ui.viewer.chain;

import atlantafx.base.theme.Styles;
import haltere.core.chain.ChainStage;
import haltere.core.chain.Filters;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.SettingField;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.VBox;

/**
 * The settings of one filter by their schema: a field for each, a heading for each group. A change
 * sends a new record to the filter.
 *
 * @param <S> the settings record
 */
final class SettingsPanel<S extends Record> extends VBox {
  private final ChainStage stage;
  private final ChainEditor editor;
  private final SettingsSchema<S> schema;
  private final List<SettingField> fields = new ArrayList<>();
  private final Map<String, Label> headings = new LinkedHashMap<>();
  private final Button resetAll = new Button("Reset all to defaults");

  /** The present record, as known to this panel. */
  private S settings;

  private SettingsPanel(
      ChainStage stage, S settings, SettingsSchema<S> schema, ChainEditor editor) {
    this.stage = stage;
    this.settings = settings;
    this.schema = schema;
    this.editor = editor;
    String id = editor.path(stage).replace('/', '-');
    getStyleClass().add("settings");
    String group = "";
    for (Parameter parameter : schema.parameters()) {
      if (!parameter.group().equals(group)) {
        group = parameter.group();
        Label heading =
            Controls.label(
                Texts.label(group, ""), Styles.TEXT_SMALL, Styles.TEXT_BOLD, "settings-group");
        headings.put(group, heading);
        getChildren().add(heading);
      }
      SettingField field =
          SettingField.of(id, parameter, (value, refused) -> set(parameter.name(), value, refused));
      fields.add(field);
      getChildren().add(field);
    }
    Controls.named(resetAll, "reset-all-" + id, Styles.SMALL, Styles.FLAT);
    resetAll.setOnAction(event -> send(schema.defaults(), "all settings", problem -> {}));
    FlowPane starts = new FlowPane(6, 0, resetAll);
    presets().forEach((name, preset) -> starts.getChildren().add(startFrom(id, name, preset)));
    getChildren().add(starts);
    show();
  }

  /**
   * A panel for a record of any type: the present settings of a stage's filter; the editor gets new
   * ones.
   */
  @SuppressWarnings("unchecked")
  static <S extends Record> SettingsPanel<S> of(ChainStage stage, S settings, ChainEditor editor) {
    SettingsSchema<S> schema = SettingsSchema.of((Class<S>) settings.getClass());
    return new SettingsPanel<>(stage, settings, schema, editor);
  }

  @SuppressWarnings("unchecked")
  private Map<String, S> presets() {
    var provider = Filters.all().get(stage.kind());
    return provider != null && provider.settingsType() == settings.getClass()
        ? (Map<String, S>) provider.presets()
        : Map.of();
  }

  private Button startFrom(String id, String name, S preset) {
    return Controls.button(
        "preset-" + name + "-" + id,
        "Preset: " + name,
        "Applies all settings of the preset " + name,
        () -> send(preset, "all settings", problem -> {}),
        Styles.SMALL,
        Styles.FLAT);
  }

  private void set(String name, Object value, Consumer<String> refused) {
    try {
      S changed = schema.with(settings, name, value);
      if (!changed.equals(settings)) {
        Parameter parameter = schema.parameter(name);
        send(changed, Texts.label(parameter).toLowerCase(Locale.ROOT), refused);
      }
    } catch (SettingsProblem problem) {
      refused.accept(problem.getMessage());
    }
  }

  private void send(S changed, String subject, Consumer<String> refused) {
    editor.apply(stage, settings, changed, subject, refused);
  }

  /** Shows settings that the filter was given. */
  void adopt(Record adopted) {
    if (adopted.getClass() == settings.getClass()) {
      @SuppressWarnings("unchecked")
      S same = (S) adopted;
      settings = same;
      show();
    }
  }

  /** Shows only matching settings; returns their number. */
  int narrow(SettingsSearch search) {
    List<String> changed = schema.changed(settings);
    Set<String> shownGroups = new HashSet<>();
    int shown = 0;
    for (SettingField field : fields) {
      boolean matches =
          search.matches(field.parameter(), changed.contains(field.parameter().name()));
      Controls.show(matches, field);
      if (matches) {
        shown++;
        shownGroups.add(field.parameter().group());
      }
    }
    headings.forEach((group, heading) -> Controls.show(shownGroups.contains(group), heading));
    return shown;
  }

  private void show() {
    List<String> changed = schema.changed(settings);
    for (SettingField field : fields) {
      String name = field.parameter().name();
      field.show(schema.get(settings, name), changed.contains(name));
    }
    resetAll.setDisable(changed.isEmpty());
  }
}
