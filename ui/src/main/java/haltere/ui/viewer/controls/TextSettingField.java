package haltere.ui.viewer.controls;

import atlantafx.base.theme.Styles;
import haltere.core.settings.Parameter;
import javafx.scene.control.TextField;

/**
 * A setting that is a text.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class TextSettingField extends SettingField {
  private final TextField entry = new TextField();

  TextSettingField(String stage, Parameter parameter, Change change) {
    super(stage, parameter, change);
    entry.setId("entry-" + controlId());
    entry.setAccessibleText(Texts.label(parameter));
    Controls.help(entry, help());
    entry.setPrefColumnCount(12);
    entry.getStyleClass().add(Styles.SMALL);
    Controls.onEntered(entry, () -> set(entry.getText()));
    layOutBelow(entry);
  }

  @Override
  void showValue(Object value) {
    entry.setText(text(value));
  }
}
