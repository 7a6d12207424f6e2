package haltere.ui.viewer.space;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.SpaceTimeCloud;
import haltere.ui.rendering.SpaceTimePainter;
import haltere.ui.rendering.SpaceTimeView;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.KeyPane;
import haltere.ui.viewer.controls.Texts;
import java.nio.IntBuffer;
import java.util.function.DoubleConsumer;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.shape.Rectangle;

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
  private final ImageView image = new ImageView();
  private final KeyPane picture = new KeyPane(image);
  private final Slider turn = slider("space-time-turn", "Turn, degrees", -180, 180);
  private final Slider tilt = slider("space-time-tilt", "Tilt, degrees", -90, 90);
  private final Slider size = slider("space-time-size", "Size, in doublings", -2, 4.5);
  private final Slider span = slider("space-time-span", "Time shown, as a power of ten", 3, 7);
  private final Slider slice = slider("space-time-slice", "Where the slice begins", 0, 1);
  private final Slider thickness = slider("space-time-thickness", "How thick the slice is", 0, 1);
  private final Label words = new Label();
  private PixelBuffer<IntBuffer> pixels;
  private SpaceTimeCloud.Points points = new SpaceTimeCloud.Points(1);
  private SensorGeometry sensor = new SensorGeometry(128, 128);
  private ColourMap colours = ColourMap.DARK;
  private double dragX;
  private double dragY;
  private boolean dirty = true;

  SpaceTimePanel() {
    setId("space-time");
    getStyleClass().add("space-time");
    picture.setId("space-time-picture");
    picture.setAccessibleText("Events in space and time");
    picture.setMinSize(120, 120);
    image.setManaged(false);
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(picture.widthProperty());
    clip.heightProperty().bind(picture.heightProperty());
    picture.setClip(clip);
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
    points = new SpaceTimeCloud.Points(1);
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
  void update(SpaceTimeCloud.Points newer) {
    if (newer != null) {
      points = newer;
      dirty = true;
    }
    int width = (int) picture.getWidth();
    int height = (int) picture.getHeight();
    if (!dirty || width < 2 || height < 2) {
      return;
    }
    dirty = false;
    if (pixels == null || pixels.getWidth() != width || pixels.getHeight() != height) {
      pixels =
          new PixelBuffer<>(
              width,
              height,
              IntBuffer.allocate(width * height),
              PixelFormat.getIntArgbPreInstance());
      image.setImage(new WritableImage(pixels));
    }
    SpaceTimeView view = view();
    pixels.updateBuffer(
        buffer -> {
          painter.paint(points, sensor, view, colours, width, height, buffer.getBuffer().array());
          return null;
        });
    words.setText(Texts.duration(view.spanUs()) + ", " + Texts.count(points.count()) + " events");
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
