package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.SpaceTimeCloud;
import haltere.ui.rendering.SpaceTimePainter;
import haltere.ui.rendering.SpaceTimeView;
import java.nio.IntBuffer;
import java.util.function.DoubleConsumer;
import javafx.geometry.Pos;
import javafx.scene.AccessibleRole;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.shape.Rectangle;

/**
 * Events in space and time. A drag turns, the wheel enlarges, a double click goes back to the first
 * view; sliders do the same from the keyboard and choose the part of the time that stands out.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SpaceTimePanel extends BorderPane {
  private static final double RAD_PER_UNIT = 0.008;
  private static final double ZOOM_PER_NOTCH = 1.15;

  private final SpaceTimePainter painter = new SpaceTimePainter();
  private final ImageView image = new ImageView();
  private final Pane picture = new Pane(image);
  private final Slider turn = slider("space-time-turn", "Turn, degrees", -180, 180);
  private final Slider tilt = slider("space-time-tilt", "Tilt, degrees", -90, 90);
  private final Slider span = slider("space-time-span", "Time shown, as a power of ten", 3, 7);
  private final Slider slice = slider("space-time-slice", "Where the slice begins", 0, 1);
  private final Slider thickness = slider("space-time-thickness", "How thick the slice is", 0, 1);
  private final Label words = new Label();
  private PixelBuffer<IntBuffer> pixels;
  private SpaceTimeCloud.Points points = new SpaceTimeCloud.Points(1);
  private SensorGeometry sensor = new SensorGeometry(128, 128);
  private ColourMap colours = ColourMap.DARK;
  private double zoom = 1;
  private double dragX;
  private double dragY;
  private boolean dirty = true;

  SpaceTimePanel() {
    setId("space-time");
    getStyleClass().add("space-time");
    picture.setId("space-time-picture");
    picture.setAccessibleRole(AccessibleRole.IMAGE_VIEW);
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
          zoom *= Math.pow(ZOOM_PER_NOTCH, Math.signum(event.getDeltaY()));
          zoom = Math.max(0.2, Math.min(20, zoom));
          dirty = true;
          event.consume();
        });
    setCenter(picture);
    words.getStyleClass().addAll(Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    FlowPane controls =
        new FlowPane(
            10,
            2,
            named("Turn", turn),
            named("Tilt", tilt),
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
        zoom,
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
    zoom = first.zoom();
    dirty = true;
  }

  private void pressed(MouseEvent event) {
    dragX = event.getX();
    dragY = event.getY();
    if (event.getClickCount() == 2) {
      goBack();
    }
  }

  private void dragged(MouseEvent event) {
    double degrees = Math.toDegrees(RAD_PER_UNIT);
    double turned = turn.getValue() + (event.getX() - dragX) * degrees;
    turn.setValue(turned > 180 ? turned - 360 : turned < -180 ? turned + 360 : turned);
    tilt.setValue(tilt.getValue() + (event.getY() - dragY) * degrees);
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
