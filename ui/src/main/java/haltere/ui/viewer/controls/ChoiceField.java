package haltere.ui.viewer.controls;

import haltere.core.settings.Parameter;
import javafx.scene.control.ChoiceBox;

/**
 * A setting that is one of a few words.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ChoiceField extends SettingField {
  private final ChoiceBox<String> box = new ChoiceBox<>();

  ChoiceField(String stage, Parameter parameter, Change change) {
    super(stage, parameter, change);
    box.setId("choice-" + controlId());
    box.getItems().setAll(parameter.choices());
    box.setAccessibleText(Texts.label(parameter));
    Controls.help(box, help());
    box.setOnAction(
        event -> {
          if (box.getValue() != null) {
            set(box.getValue());
          }
        });
    box.setMaxWidth(Double.MAX_VALUE);
    layOutBelow(box);
  }

  @Override
  void showValue(Object value) {
    box.setValue(text(value));
  }
}
