package haltere.ui.viewer.controls;

import atlantafx.base.theme.Styles;
import haltere.core.settings.Parameter;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;

/** A number: a slider for finding a value, an entry for an exact one. */
final class NumberField extends SettingField {
  private final SliderScale scale;
  private final Slider slider = new Slider(0, 1, 0);
  private final TextField entry = new TextField();
  private boolean showing;

  NumberField(String stage, Parameter parameter, Change change) {
    super(stage, parameter, change);
    scale = SliderScale.of(parameter);
    control(slider, "slider-");
    slider.setBlockIncrement(0.01);
    slider.getStyleClass().add(Styles.SMALL);
    slider
        .valueProperty()
        .subscribe(
            (old, now) -> {
              if (!showing) {
                set(scale.value(now.doubleValue()));
              }
            });
    control(entry, "entry-").setAccessibleText(Texts.label(parameter) + " exactly");
    entry.setPrefColumnCount(6);
    entry.setAlignment(Pos.CENTER_RIGHT);
    entry.getStyleClass().add(Styles.SMALL);
    Controls.onEntered(entry, () -> set(entry.getText()));
    entry.setOnKeyPressed(
        event -> {
          if (event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN) {
            slider.setValue(slider.getValue() + (event.getCode() == KeyCode.UP ? 0.01 : -0.01));
            event.consume();
          }
        });
    Label unit = Controls.whole(unit(), Styles.TEXT_SMALL, Styles.TEXT_MUTED, "unit");
    slider.setMaxWidth(Double.MAX_VALUE);
    layOutBelow(slider, entry, unit);
  }

  @Override
  void showValue(Object value) {
    showing = true;
    double position = scale.position(((Number) value).doubleValue());
    if (!slider.isValueChanging() || Math.abs(slider.getValue() - position) > 0.02) {
      slider.setValue(position);
    }
    entry.setText(text(value));
    showing = false;
  }
}
