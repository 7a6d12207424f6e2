package haltere.ui.viewer.picture;

import haltere.ui.rendering.ColourScale;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.controls.Controls;
import java.util.Optional;
import java.util.StringJoiner;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** A strip of colours with the meaning of its ends, for ages and counts. */
public final class ScaleLegend extends HBox {
  private final Label first = new Label();
  private final Region strip = new Region();
  private final Label last = new Label();
  private DisplayMode mode = DisplayMode.POLARITY;
  private Gradient gradient = Gradient.CIVIDIS;

  ScaleLegend() {
    super(6);
    Controls.named(this, "scale-legend", "readout", "scale-legend");
    setAlignment(Pos.CENTER);
    setManaged(false);
    setMouseTransparent(true);
    setVisible(false);
    strip.setMinSize(12, 8);
    strip.setPrefSize(90, 8);
    first.setMinWidth(USE_PREF_SIZE);
    last.setMinWidth(USE_PREF_SIZE);
    getChildren().addAll(first, strip, last);
  }

  /** Takes the colours of a mode. */
  public void configure(DisplayMode newMode, Gradient newGradient) {
    mode = newMode;
    gradient = newGradient;
    StringJoiner stops = new StringJoiner(", ");
    for (int anchor : gradient.anchors()) {
      stops.add(String.format("#%06x", anchor & 0xFFFFFF));
    }
    strip.setStyle("-fx-background-color: linear-gradient(to right, " + stops + ");");
  }

  /** Shows the meaning of the far end; empty hides the legend. */
  void show(String farEnd) {
    Optional<ColourScale> scale = ColourScale.of(mode, gradient, farEnd);
    setVisible(scale.isPresent());
    scale.ifPresent(this::show);
  }

  private void show(ColourScale scale) {
    if (!(scale.first().equals(first.getText()) && scale.last().equals(last.getText()))) {
      first.setText(scale.first());
      last.setText(scale.last());
      getParent().requestLayout();
    }
  }
}
