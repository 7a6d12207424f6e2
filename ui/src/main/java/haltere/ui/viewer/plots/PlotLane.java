package haltere.ui.viewer.plots;

import haltere.ui.plot.Curve;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.TimeWindow;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.KeyPane;
import haltere.ui.viewer.controls.PixelImage;
import haltere.ui.viewer.controls.Texts;
import java.util.List;
import java.util.stream.Collectors;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Pane;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Circle;
import javafx.scene.shape.Line;

/** A lane in the window: its name, the newest values or those under the mouse, and the plot. */
final class PlotLane extends BorderPane {
  private static final int NAMED_CURVES = 8;

  private final Lane lane;
  private final TimeWindow window;
  private final LanePicture picture;
  private final Canvas canvas = new Canvas();
  private final Line cursor = new Line();
  private final Line now = new Line();
  private final KeyPane stack;
  private final HBox head = Controls.row(8);
  private final HBox values = Controls.row(10);
  private final Label title = Controls.label("", "plot-title");
  private final Label more = new Label();
  private final Label note = Controls.named(new Label(), "plot-note", "plot-note");

  /** A lane without a plot yet. */
  PlotLane(Lane lane, TimeWindow window) {
    this.lane = lane;
    this.window = window;
    picture = new LanePicture(lane, window);
    stack = new KeyPane(canvas, picture.curves(), now, cursor);
    getStyleClass().add("plot-lane");
    title.setMinWidth(Region.USE_PREF_SIZE);
    values.setMinWidth(0);
    values.setPrefWidth(0);
    Controls.clip(values);
    values.getStyleClass().add("plot-values");
    head.getChildren().addAll(title, Controls.growing(values));
    head.getStyleClass().addAll("plot-head");
    setTop(head);
    cursor.setVisible(false);
    now.setVisible(false);
    for (Line line : List.of(cursor, now)) {
      line.setManaged(false);
      line.setMouseTransparent(true);
    }
    canvas.setManaged(false);
    note.relocate(LanePicture.LEFT + 10, 8);
    note.setVisible(false);
    stack.getChildren().add(note);
    stack.setMinHeight(48);
    setCenter(stack);
    showTitle();
  }

  /** Adds buttons at the right of its head. */
  void addButtons(Button... buttons) {
    head.getChildren().addAll(buttons);
  }

  Lane lane() {
    return lane;
  }

  /** The part of the lane that mouse and keys work on. */
  Pane plot() {
    return stack;
  }

  void add(PlotField field) {
    lane.add(field);
    showTitle();
  }

  /** Shows a note if the chain publishes nothing of the lane. */
  void followPublished(List<PlotField> published) {
    boolean any =
        lane.fields().stream()
            .anyMatch(field -> field.equals(PlotField.EVENT_RATE) || published.contains(field));
    note.setVisible(!any);
    note.setText(
        "Nothing in the chain publishes "
            + lane.fields().stream().map(PlotField::toString).collect(Collectors.joining(", ")));
  }

  private void showTitle() {
    String text =
        lane.fields().stream().map(PlotLane::label).distinct().collect(Collectors.joining(", "));
    title.setText(text);
    Controls.help(
        title, lane.fields().stream().map(PlotField::toString).collect(Collectors.joining("\n")));
    stack.setAccessibleText("Plot of " + text);
  }

  private static String label(PlotField field) {
    return field.equals(PlotField.EVENT_RATE)
        ? "Event rate"
        : Texts.title(field.outlet()) + ": " + field.label();
  }

  /** Redraws all. */
  void draw(PlotColours colours, long nowUs, long startUs) {
    double width = stack.getWidth();
    double height = stack.getHeight();
    if (width < 2 || height < 2) {
      return;
    }
    if (canvas.getWidth() != width || canvas.getHeight() != height) {
      canvas.setWidth(width);
      canvas.setHeight(height);
    }
    GraphicsContext graphics = canvas.getGraphicsContext2D();
    double density = PixelImage.density(this);
    picture.draw(graphics, width, height, density, colours, startUs);
    double share = window.shareOf(nowUs);
    move(now, !window.isFollowing() && share >= 0 && share <= 1, share, colours.now());
  }

  /** Shows the values at a share of the window, under the mouse, or the newest ones for NaN. */
  void showValues(double share, PlotColours colours) {
    boolean pointed = share >= 0 && share <= 1;
    move(cursor, pointed, share, colours.cursor());
    List<Curve> curves =
        lane.curves().stream().filter(curve -> curve.lastUs() >= window.fromUs()).toList();
    long atUs = pointed ? window.timeAt(share) : 0;
    int shown = Math.min(NAMED_CURVES, curves.size());
    while (values.getChildren().size() > shown) {
      values.getChildren().remove(values.getChildren().size() - 1);
    }
    for (int i = 0; i < shown; i++) {
      // The latest: tracks from before a jump back have not ended within the window either.
      Curve curve = curves.get(curves.size() - shown + i);
      if (values.getChildren().size() <= i) {
        Label label = Controls.whole("");
        label.setGraphic(new Circle(4));
        values.getChildren().add(label);
      }
      Label label = (Label) values.getChildren().get(i);
      ((Circle) label.getGraphic()).setFill(colours.curve(curve));
      double value = pointed ? curve.valueAt(atUs) : curve.last();
      label.setText(curve.key() + " " + label(value, lane.unit(curve)));
    }
    if (curves.size() > NAMED_CURVES) {
      more.setText("+" + (curves.size() - NAMED_CURVES));
      values.getChildren().add(more);
    }
  }

  private static String label(double value, String unit) {
    return Double.isNaN(value)
        ? "\u2013"
        : Texts.number(value) + (unit.isEmpty() ? "" : " " + unit);
  }

  private void move(Line line, boolean visible, double share, Color colour) {
    line.setVisible(visible);
    if (visible) {
      double x = Math.rint(LanePicture.x(share, stack.getWidth())) + 0.5;
      line.setStartX(x);
      line.setEndX(x);
      line.setEndY(stack.getHeight());
      line.setStroke(colour);
    }
  }
}
