package haltere.ui.viewer.space;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.FontLetters;
import haltere.ui.rendering.Letters;
import haltere.ui.rendering.PixelOverlayCanvas;
import haltere.ui.rendering.SpaceTimePainter;
import haltere.ui.rendering.SpaceTimeProjection;
import haltere.ui.rendering.SpaceTimeView;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.PixelImage;
import haltere.ui.viewer.controls.RotatablePane;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;

/**
 * Events in space and time. A drag rotates, the wheel zooms, a double click restores the initial
 * view; arrow keys, plus, minus, Home and sliders do the same. Sliders also select the highlighted
 * slice.
 */
final class SpaceTimePanel extends BorderPane {
  private static final double DOUBLINGS_PER_NOTCH = 0.2;

  /** Room for the value beside a slider, so that nothing moves while it changes. */
  private static final double VALUE_WIDTH = 46;

  private final SpaceTimePainter painter = new SpaceTimePainter();
  private final PixelImage image = new PixelImage();
  private final RotatablePane picture = Controls.named(new Picture(), "space-time-picture");
  private final Slider turn = slider("space-time-turn", "Turn, degrees", -180, 180);
  private final Slider tilt = slider("space-time-tilt", "Tilt, degrees", -90, 90);
  private final Slider size = slider("space-time-size", "Size, in doublings", -2, 4.5);
  private final Slider span = slider("space-time-span", "Time shown, as a power of ten", 3, 7);
  private final Slider slice =
      slider("space-time-slice", "Where the highlighted slice begins", 0, 1);
  private final Slider thickness =
      slider("space-time-thickness", "Thickness of the highlighted slice", 0, 1);
  private final Label text = Controls.label("", Styles.TEXT_SMALL, Styles.TEXT_MUTED);
  private final List<Runnable> values = new ArrayList<>();
  private final ReadOnlyBooleanProperty marksShown;
  private SpaceTimeSink.Frame frame = new SpaceTimeSink.Frame(1);
  private SensorGeometry sensor = new SensorGeometry(128, 128);
  private ColourMap colours = ColourMap.DARK;
  private boolean dirty = true;

  /** A panel that shows no events yet, and marks of filters while they are shown. */
  SpaceTimePanel(ReadOnlyBooleanProperty marksShown) {
    this.marksShown = marksShown;
    marksShown.subscribe(() -> dirty = true);
    Controls.named(this, "space-time", "space-time");
    picture.setAccessibleText("Events in space and time");
    picture.setMinSize(120, 120);
    Controls.clip(picture);
    picture.layoutBoundsProperty().subscribe(bounds -> dirty = true);
    setCenter(picture);
    FlowPane controls =
        new FlowPane(
            10,
            2,
            named("Turn", turn, () -> Math.round(turn.getValue()) + "°"),
            named("Tilt", tilt, () -> Math.round(tilt.getValue()) + "°"),
            named("Size", size, () -> Texts.digits(view().zoom()) + "×"),
            named("Time", span, () -> Texts.duration(view().spanUs())),
            named("Slice", slice, () -> slice.getValue() == 0 ? "now" : "-" + ofSpan(slice)),
            named("Thickness", thickness, () -> ofSpan(thickness)),
            text);
    controls.getStyleClass().addAll("space-time-controls");
    setBottom(controls);
    goBack();
  }

  void setSensor(SensorGeometry newSensor) {
    sensor = newSensor;
    frame = new SpaceTimeSink.Frame(1);
    dirty = true;
  }

  void setColours(ColourMap newColours) {
    colours = newColours;
    dirty = true;
  }

  SpaceTimeView view() {
    double from = slice.getValue();
    return new SpaceTimeView(
        Math.toRadians(turn.getValue()),
        Math.toRadians(tilt.getValue()),
        Math.pow(2, size.getValue()),
        Math.round(Math.pow(10, span.getValue())),
        from,
        Math.min(1, from + thickness.getValue()));
  }

  /** Adds a listener to the shown time span. */
  void onSpan(DoubleConsumer listener) {
    span.valueProperty().subscribe((was, is) -> listener.accept(view().spanUs()));
  }

  /** Shows newer events, or the same ones from another viewpoint; null without newer ones. */
  void update(SpaceTimeSink.Frame newer) {
    if (newer != null) {
      frame = newer;
      dirty = true;
    }
    double density = PixelImage.density(this);
    int width = (int) (picture.getWidth() * density);
    int height = (int) (picture.getHeight() * density);
    if (dirty && width >= 2 && height >= 2) {
      dirty = false;
      paint(width, height, density);
    }
  }

  private void paint(int width, int height, double density) {
    image.fit(width, height, density);
    SpaceTimeView view = view();
    double room = 2 * SpaceTimeMarks.room() * density;
    SpaceTimeProjection projection =
        new SpaceTimeProjection(
            view, sensor, Math.max(1, width - room), Math.max(1, height - room));
    painter.paint(frame.points, projection, view, colours, width, height, image.pixels());
    Letters letters = FontLetters.ofView(density);
    PixelOverlayCanvas canvas = new PixelOverlayCanvas(letters);
    canvas.setTarget(image.pixels(), width, height);
    canvas.setDark(colours.dark());
    canvas.setView(1 / density, (width - 1) / 2.0 / density, (height + 1) / 2.0 / density, density);
    SpaceTimeMarks marks =
        new SpaceTimeMarks(projection, sensor, view.spanUs(), letters, density, canvas);
    marks.drawAxes();
    if (marksShown.get()) {
      marks.draw(frame);
    }
    image.repaint();
    values.forEach(Runnable::run);
    String steps = ", traces in steps of " + Texts.duration(SpaceTimeSink.stepUs(view.spanUs()));
    text.setText(
        Texts.count(frame.points.count())
            + (frame.traces.isEmpty() ? " events" : " events" + steps));
  }

  /** A share of the shown time span as text. */
  private String ofSpan(Slider share) {
    return Texts.duration(share.getValue() * view().spanUs());
  }

  private void goBack() {
    SpaceTimeView first = SpaceTimeView.DEFAULT;
    turn.setValue(Math.toDegrees(first.turnRad()));
    tilt.setValue(Math.toDegrees(first.tiltRad()));
    span.setValue(Math.log10(first.spanUs()));
    slice.setValue(first.sliceFrom());
    thickness.setValue(first.sliceTo());
    size.setValue(Math.log(first.zoom()) / Math.log(2));
    dirty = true;
  }

  /** The picture, rotated by mouse and keys. */
  private final class Picture extends RotatablePane {
    Picture() {
      super(image);
    }

    @Override
    protected void turn(double rightDegrees, double downDegrees) {
      double turned = turn.getValue() + rightDegrees;
      turn.setValue(turned > 180 ? turned - 360 : turned < -180 ? turned + 360 : turned);
      tilt.setValue(tilt.getValue() + downDegrees);
    }

    @Override
    protected void zoom(double notches) {
      size.setValue(size.getValue() + notches * DOUBLINGS_PER_NOTCH);
    }

    @Override
    protected void goBack() {
      SpaceTimePanel.this.goBack();
    }
  }

  private Slider slider(String id, String help, double min, double max) {
    Slider slider = Controls.slider(id, help, min, max);
    slider.getStyleClass().add(Styles.SMALL);
    slider.setPrefWidth(60);
    slider.setBlockIncrement((max - min) / 50);
    slider.valueProperty().subscribe((was, is) -> dirty = true);
    return slider;
  }

  /** A slider between its name and its value, which is updated with the picture. */
  private HBox named(String name, Slider slider, Supplier<String> value) {
    Label shown = Controls.named(new Label(), slider.getId() + "-value", Styles.TEXT_SMALL);
    shown.setMinWidth(VALUE_WIDTH);
    values.add(() -> shown.setText(value.get()));
    Label title = Controls.label(name, Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    return Controls.row(4, title, slider, shown);
  }
}
