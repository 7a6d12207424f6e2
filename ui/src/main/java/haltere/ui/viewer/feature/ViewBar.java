package haltere.ui.viewer.feature;

import atlantafx.base.theme.Styles;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import java.util.Collection;
import java.util.List;
import java.util.function.Function;
import javafx.beans.binding.BooleanBinding;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.Property;
import javafx.beans.value.ObservableBooleanValue;
import javafx.geometry.Pos;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** The bar above the events: display mode, fading and tools. */
public final class ViewBar extends HBox {
  /** Width, pixels, below which only choices and buttons are shown. */
  private static final double WIDE_PX = 460;

  /** Width of the choice of the display mode, which leaves room for longer labels of fading. */
  private static final double MODE_PX = 160;

  private final HBox tools = Controls.row(2);
  private final BooleanBinding isWide = widthProperty().greaterThan(WIDE_PX);

  ViewBar(DisplayControl display) {
    super(6);
    getStyleClass().add("view-bar");
    setAlignment(Pos.CENTER_LEFT);
    Label text = Controls.whole("Fading", Styles.TEXT_MUTED, Styles.TEXT_SMALL);
    Controls.bindVisible(isWide, text);
    Region mode =
        choice(
            "show-as",
            "Meaning of the colour of a pixel",
            display.modeProperty(),
            List.of(DisplayMode.values()),
            DisplayMode::label);
    mode.setPrefWidth(MODE_PX);
    getChildren()
        .addAll(
            mode,
            text,
            choice(
                "fading",
                "Fading time of events, or only those of the last slice",
                display.decayUsProperty(),
                DisplayControl.DECAYS.keySet(),
                DisplayControl.DECAYS::get),
            Controls.growing(new Region()),
            tools);
  }

  /** Adds the switch of the camera's frames and their opacity, for sources with frames. */
  public void addFrames(BooleanProperty on, DoubleProperty opacity, ObservableBooleanValue seen) {
    ToggleButton button =
        Controls.toggle("frames", Icons.FRAME, "Frames below the events", Styles.SMALL);
    button.selectedProperty().bindBidirectional(on);
    Slider slider = Controls.slider("frame-opacity", "Opacity of the frames", 0.1, 1);
    slider.setValue(opacity.get());
    slider.setPrefWidth(80);
    slider.setMinWidth(40);
    slider.valueProperty().bindBidirectional(opacity);
    slider.disableProperty().bind(on.not());
    Controls.bindVisible(seen, button);
    Controls.bindVisible(isWide.and(seen), slider);
    getChildren().addAll(getChildren().indexOf(tools) - 1, List.of(button, slider));
  }

  /** Adds the button of a tool or a panel, in a {@link Controls#place place}. */
  public ToggleButton tool(String id, Icons icon, String help, BooleanProperty on) {
    ToggleButton button = Controls.toggle(id, icon, help, Styles.SMALL);
    button.selectedProperty().bindBidirectional(on);
    tools.getChildren().add(Controls.place(button));
    return button;
  }

  private static <T> Region choice(
      String id,
      String help,
      Property<T> property,
      Collection<T> values,
      Function<T, String> text) {
    ChoiceBox<T> box = Controls.choice(id, help, values, text);
    box.getStyleClass().add(Styles.SMALL);
    box.setMinWidth(90);
    box.valueProperty().bindBidirectional(property);
    return box;
  }
}
