package haltere.ui.viewer.picture;

import haltere.core.overlay.OverlayCanvas;
import java.util.Optional;
import javafx.beans.property.ObjectProperty;

/** Measures length and angle of a drag. */
public final class MeasuringTape implements ViewTool {
  private final ObjectProperty<Optional<MeasuredLine>> measured;
  private double fromX;
  private double fromY;

  /** A tape; publishes the measurement, and empty when the tape is dismissed. */
  public MeasuringTape(ObjectProperty<Optional<MeasuredLine>> measured) {
    this.measured = measured;
  }

  @Override
  public String hint() {
    return "Drag over the picture to measure a length and an angle.";
  }

  @Override
  public void pressed(double x, double y) {
    measured.set(Optional.empty());
    fromX = x;
    fromY = y;
  }

  @Override
  public void dragged(double x, double y) {
    measured.set(Optional.of(new MeasuredLine(fromX, fromY, x, y)));
  }

  @Override
  public void dismiss() {
    measured.set(Optional.empty());
  }

  @Override
  public void draw(OverlayCanvas canvas) {
    measured.get().ifPresent(line -> line.draw(canvas));
  }
}
