package haltere.ui.viewer.controls;

import atlantafx.base.theme.Styles;
import haltere.core.settings.Parameter;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.layout.HBox;
import javafx.scene.layout.VBox;

/**
 * One setting: its name, a control for its type, a button for the default, and a line for errors of
 * an entry.
 */
public final class SettingField extends VBox {
  /** Accepts a value from the user. */
  public interface Change {
    /**
     * Tries a text or a value of the setting's type; reports the reason of a refusal in one line.
     */
    void to(Object value, Consumer<String> refused);
  }

  private final Parameter parameter;
  private final Change change;
  private final Button reset;
  private final Label problem = Controls.paragraph("", Styles.TEXT_SMALL, Styles.DANGER, "problem");
  private final Label name = new Label();
  private final String id;

  private Object shown;

  /** Puts a value into the control, whose own listeners must not take it for a change. */
  private Consumer<Object> shower = value -> {};

  private SettingField(String stage, Parameter parameter, Change change) {
    this.parameter = parameter;
    this.change = change;
    this.id = stage + "-" + parameter.name().replace('.', '-');
    getStyleClass().add("setting");
    name.setText(Texts.label(parameter));
    Controls.help(name, help());
    name.setMinWidth(0);
    reset =
        Controls.button(
            "reset-" + id,
            Icons.RESET,
            "Back to the default, " + Parameter.text(parameter.defaultValue()) + " " + unit(),
            () -> set(parameter.defaultValue()),
            Styles.SMALL,
            "reset-setting");
    problem.setId("problem-" + id);
    showProblem("");
  }

  /** The field that suits a setting's type. */
  public static SettingField of(String stage, Parameter parameter, Change change) {
    SettingField field = new SettingField(stage, parameter, change);
    if (parameter.isNumber()) {
      field.addNumber();
    } else if (parameter.type() == boolean.class) {
      field.addCheckBox();
    } else if (parameter.type().isEnum()) {
      field.addChoice();
    } else {
      field.addText();
    }
    return field;
  }

  /** A slider for finding a value, an entry for an exact one. */
  private void addNumber() {
    SliderScale scale = SliderScale.of(parameter);
    Slider slider = control(new Slider(0, 1, 0), "slider-");
    slider.setBlockIncrement(0.01);
    slider.getStyleClass().add(Styles.SMALL);
    boolean[] showing = new boolean[1];
    slider
        .valueProperty()
        .subscribe(
            (old, now) -> {
              if (!showing[0]) {
                set(scale.value(now.doubleValue()));
              }
            });
    TextField entry = entry(6);
    entry.setAccessibleText(Texts.label(parameter) + " exactly");
    entry.setAlignment(Pos.CENTER_RIGHT);
    entry.setOnKeyPressed(
        event -> {
          if (event.getCode() == KeyCode.UP || event.getCode() == KeyCode.DOWN) {
            slider.setValue(slider.getValue() + (event.getCode() == KeyCode.UP ? 0.01 : -0.01));
            event.consume();
          }
        });
    shower =
        value -> {
          showing[0] = true;
          double position = scale.position(((Number) value).doubleValue());
          if (!slider.isValueChanging() || Math.abs(slider.getValue() - position) > 0.02) {
            slider.setValue(position);
          }
          entry.setText(Parameter.text(value));
          showing[0] = false;
        };
    layOutBelow(
        slider, entry, Controls.whole(unit(), Styles.TEXT_SMALL, Styles.TEXT_MUTED, "unit"));
  }

  private TextField entry(int columns) {
    TextField entry = control(new TextField(), "entry-");
    entry.setPrefColumnCount(columns);
    entry.getStyleClass().add(Styles.SMALL);
    Controls.onEntered(entry, () -> set(entry.getText()));
    Controls.onEscape(entry, () -> show(shown, reset.isVisible()));
    return entry;
  }

  private void addCheckBox() {
    CheckBox box = control(new CheckBox(), "check-");
    box.setOnAction(event -> set(box.isSelected()));
    shower = value -> box.setSelected((Boolean) value);
    getChildren().addAll(line(name, reset, box), problem);
  }

  private void addChoice() {
    ChoiceBox<String> box = control(new ChoiceBox<>(), "choice-");
    box.getItems().setAll(parameter.choices());
    box.setOnAction(event -> Optional.ofNullable(box.getValue()).ifPresent(this::set));
    shower = value -> box.setValue(Parameter.text(value));
    layOutBelow(box);
  }

  private void addText() {
    TextField entry = entry(12);
    shower = value -> entry.setText(Parameter.text(value));
    layOutBelow(entry);
  }

  /** A control of the setting; the prefix of its id is its kind. */
  private <T extends Control> T control(T made, String kind) {
    made.setId(kind + id);
    made.setAccessibleText(Texts.label(parameter));
    Controls.help(made, help());
    return made;
  }

  /** Which setting it is. */
  public Parameter parameter() {
    return parameter;
  }

  /** Shows the present value. */
  public void show(Object value, boolean changed) {
    reset.setVisible(changed);
    showProblem("");
    shown = value;
    shower.accept(value);
  }

  private String help() {
    String ends = Parameter.text(parameter.min()) + " to " + Parameter.text(parameter.max());
    String range = parameter.isNumber() ? "\n" + ends + " " + unit() : "";
    return parameter.help() + range;
  }

  private String unit() {
    return Texts.unit(parameter.unit());
  }

  /** The name, and below it controls that take the whole width. */
  private void layOutBelow(Control... controls) {
    Controls.growing(controls[0]);
    getChildren().addAll(line(name, reset), line(controls), problem);
  }

  private HBox line(Node... nodes) {
    Controls.growing(name);
    return Controls.row(6, nodes);
  }

  /** A person has set a value. */
  private void set(Object value) {
    showProblem("");
    change.to(value, this::showProblem);
  }

  private void showProblem(String line) {
    problem.setText(line);
    Controls.show(!line.isEmpty(), problem);
  }
}
