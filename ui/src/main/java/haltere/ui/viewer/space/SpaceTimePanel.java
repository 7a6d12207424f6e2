package haltere.ui.viewer.space;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.ui.overlay.FontLetters;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.PixelOverlayCanvas;
import haltere.ui.rendering.SpaceTimePainter;
import haltere.ui.rendering.SpaceTimeProjection;
import haltere.ui.rendering.SpaceTimeView;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.KeyPane;
import haltere.ui.viewer.controls.PixelImage;
import haltere.ui.viewer.controls.Texts;
import java.util.function.DoubleConsumer;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.text.Font;

/**
 * Events in space and time. A drag turns, the wheel enlarges, a double click goes back to the first
 * view; arrow keys, plus, minus and Home do the same, and sliders, which also choose the part of
 * the time that stands out.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SpaceTimePanel extends BorderPane {
  private static final double RAD_PER_UNIT = 0.008;
  private static final double DOUBLINGS_PER_NOTCH = 0.2;
  private static final double DEGREES_PER_KEY = 5;

  private final SpaceTimePainter painter = new SpaceTimePainter();
  private final PixelImage image = new PixelImage();
  private final KeyPane picture = new KeyPane(image);
  private final Slider turn = slider("space-time-turn", "Turn, degrees", -180, 180);
  private final Slider tilt = slider("space-time-tilt", "Tilt, degrees", -90, 90);
  private final Slider size = slider("space-time-size", "Size, in doublings", -2, 4.5);
  private final Slider span = slider("space-time-span", "Time shown, as a power of ten", 3, 7);
  private final Slider slice = slider("space-time-slice", "Where the slice begins", 0, 1);
  private final Slider thickness = slider("space-time-thickness", "How thick the slice is", 0, 1);
  private final Label words = new Label();
  private final ReadOnlyBooleanProperty marksShown;
  private FontLetters letters;
  private PixelOverlayCanvas canvas;
  private double density;
  private SpaceTimeFrame frame = new SpaceTimeFrame(1);
  private SensorGeometry sensor = new SensorGeometry(128, 128);
  private ColourMap colours = ColourMap.DARK;
  private double dragX;
  private double dragY;
  private boolean dirty = true;

  /**
   * A panel that shows no events yet.
   *
   * @param marksShown whether marks of filters are drawn
   */
  SpaceTimePanel(ReadOnlyBooleanProperty marksShown) {
    this.marksShown = marksShown;
    marksShown.addListener(changed -> dirty = true);
    setId("space-time");
    getStyleClass().add("space-time");
    picture.setId("space-time-picture");
    picture.setAccessibleText("Events in space and time");
    picture.setMinSize(120, 120);
    Controls.clip(picture);
    picture.widthProperty().addListener((property, was, is) -> dirty = true);
    picture.heightProperty().addListener((property, was, is) -> dirty = true);
    picture.setOnMousePressed(this::pressed);
    picture.setOnMouseDragged(this::dragged);
    picture.setOnScroll(
        event -> {
          enlarge(Math.signum(event.getDeltaY()));
          event.consume();
        });
    picture.setOnKeyPressed(this::keyPressed);
    setCenter(picture);
    words.getStyleClass().addAll(Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    FlowPane controls =
        new FlowPane(
            10,
            2,
            named("Turn", turn),
            named("Tilt", tilt),
            named("Size", size),
            named("Time", span),
            named("Slice", slice),
            named("Thick", thickness),
            words);
    controls.getStyleClass().add("space-time-controls");
    setBottom(controls);
    goBack();
  }

  /** Another sensor. */
  void setSensor(SensorGeometry newSensor) {
    sensor = newSensor;
    frame = new SpaceTimeFrame(1);
    dirty = true;
  }

  void setColours(ColourMap newColours) {
    colours = newColours;
    dirty = true;
  }

  /** From where it is looked at. */
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

  /** Calls something with the time that is shown, whenever that changes. */
  void onSpan(DoubleConsumer listener) {
    span.valueProperty().addListener((property, was, is) -> listener.accept(view().spanUs()));
  }

  /** Shows newer events, or the same ones from elsewhere; null if there are no newer ones. */
  void update(SpaceTimeFrame newer) {
    if (newer != null) {
      frame = newer;
      dirty = true;
    }
    double newDensity = getScene() == null ? 1 : getScene().getWindow().getRenderScaleX();
    int width = (int) (picture.getWidth() * newDensity);
    int height = (int) (picture.getHeight() * newDensity);
    if (dirty && width >= 2 && height >= 2) {
      dirty = false;
      setDensity(newDensity);
      paint(width, height);
    }
  }

  private void setDensity(double newDensity) {
    if (newDensity != density) {
      density = newDensity;
      letters = new FontLetters(Font.font(JavaFxOverlayCanvas.FONT_SIZE), density);
      canvas = new PixelOverlayCanvas(letters);
    }
  }

  private void paint(int width, int height) {
    image.allocate(width, height);
    image.setFitWidth(width / density);
    image.setFitHeight(height / density);
    SpaceTimeView view = view();
    double room = 2 * SpaceTimeMarks.room() * density;
    SpaceTimeProjection projection =
        SpaceTimeProjection.of(view, sensor, Math.max(1, width - room), Math.max(1, height - room));
    painter.paint(frame.points, projection, view, colours, width, height, image.pixels());
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
    words.setText(
        Texts.duration(view.spanUs()) + ", " + Texts.count(frame.points.count()) + " events");
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

  private void enlarge(double notches) {
    size.setValue(size.getValue() + notches * DOUBLINGS_PER_NOTCH);
  }

  private void keyPressed(KeyEvent event) {
    switch (event.getCode()) {
      case LEFT, KP_LEFT -> turnBy(-DEGREES_PER_KEY, 0);
      case RIGHT, KP_RIGHT -> turnBy(DEGREES_PER_KEY, 0);
      case UP, KP_UP -> turnBy(0, -DEGREES_PER_KEY);
      case DOWN, KP_DOWN -> turnBy(0, DEGREES_PER_KEY);
      case PLUS, ADD, EQUALS -> enlarge(1);
      case MINUS, SUBTRACT -> enlarge(-1);
      case HOME -> goBack();
      default -> {
        return;
      }
    }
    event.consume();
  }

  private void turnBy(double turnDegrees, double tiltDegrees) {
    double turned = turn.getValue() + turnDegrees;
    turn.setValue(turned > 180 ? turned - 360 : turned < -180 ? turned + 360 : turned);
    tilt.setValue(tilt.getValue() + tiltDegrees);
  }

  private void pressed(MouseEvent event) {
    picture.requestFocus();
    dragX = event.getX();
    dragY = event.getY();
    if (event.getClickCount() == 2) {
      goBack();
    }
  }

  private void dragged(MouseEvent event) {
    double degrees = Math.toDegrees(RAD_PER_UNIT);
    turnBy((event.getX() - dragX) * degrees, (event.getY() - dragY) * degrees);
    dragX = event.getX();
    dragY = event.getY();
  }

  private Slider slider(String id, String help, double least, double most) {
    Slider slider = new Slider(least, most, least);
    slider.setId(id);
    slider.setAccessibleText(help);
    Controls.help(slider, help);
    slider.getStyleClass().add(Styles.SMALL);
    slider.setPrefWidth(90);
    slider.setBlockIncrement((most - least) / 50);
    slider.valueProperty().addListener((property, was, is) -> dirty = true);
    return slider;
  }

  private static HBox named(String name, Node control) {
    Label label = new Label(name);
    label.getStyleClass().addAll(Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    HBox box = new HBox(4, label, control);
    box.setAlignment(Pos.CENTER_LEFT);
    return box;
  }
}
