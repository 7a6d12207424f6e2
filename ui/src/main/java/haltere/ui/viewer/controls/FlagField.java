package haltere.ui.viewer.controls;

import haltere.core.settings.Parameter;
import javafx.scene.control.CheckBox;

/**
 * A setting that is on or off.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class FlagField extends SettingField {
  private final CheckBox box = new CheckBox();

  FlagField(String stage, Parameter parameter, Change change) {
    super(stage, parameter, change);
    box.setId("check-" + controlId());
    box.setAccessibleText(Texts.label(parameter));
    Controls.help(box, help());
    box.setOnAction(event -> set(box.isSelected()));
    layOutBeside(box);
  }

  @Override
  void showValue(Object value) {
    box.setSelected((Boolean) value);
  }
}
