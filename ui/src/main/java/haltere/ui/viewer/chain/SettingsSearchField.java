package haltere.ui.viewer.chain;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.controls.Controls;
import java.util.Locale;
import java.util.function.Consumer;
import javafx.geometry.Pos;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;

/** Searches the settings of all filters, or shows only those that a person has changed. */
final class SettingsSearchField extends HBox {
  private final TextField words = Controls.named(new TextField(), "settings-search", Styles.SMALL);
  private final ToggleButton changedOnly =
      Controls.named(new ToggleButton("Changed"), "changed-only", Styles.SMALL);
  private final Consumer<SettingsSearch> consumer;

  SettingsSearchField(Consumer<SettingsSearch> consumer) {
    super(6);
    this.consumer = consumer;
    getStyleClass().add("settings-search");
    setAlignment(Pos.CENTER_LEFT);
    words.setPromptText("Search settings");
    words.setAccessibleText("Search settings");
    HBox.setHgrow(words, Priority.ALWAYS);
    words.textProperty().subscribe((was, is) -> search());
    changedOnly.setAccessibleText("Only the settings that I changed");
    Controls.help(changedOnly, "Only the settings that are not at their defaults");
    changedOnly.selectedProperty().subscribe((was, is) -> search());
    getChildren().addAll(words, changedOnly);
  }

  private void search() {
    consumer.accept(
        new SettingsSearch(
            words.getText().strip().toLowerCase(Locale.ROOT), changedOnly.isSelected()));
  }
}
