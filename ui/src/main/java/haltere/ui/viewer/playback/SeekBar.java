package haltere.ui.viewer.playback;

import static javafx.scene.paint.Color.web;

import haltere.core.format.summary.RateProfile;
import haltere.core.playback.Loop;
import haltere.core.playback.Mark;
import haltere.core.playback.PlayerStatus;
import haltere.core.sink.internal.Ticks;
import haltere.ui.plot.Curve;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Texts;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.AccessibleAttribute;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.canvas.Canvas;
import javafx.scene.canvas.GraphicsContext;
import javafx.scene.control.Label;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import javafx.scene.shape.Rectangle;

/**
 * The whole recording at a glance: its event rate over time, the place that is shown, the loop and
 * the marks, over a ruler of times. A click or a drag seeks, a drag of an end of the loop moves it,
 * the wheel zooms. Of a camera or a scene it shows the moments that are kept.
 */
public final class SeekBar extends Region {
  /** Colours that a canvas cannot take from the style sheet, for dark and light. */
  private record Ink(Color rate, Color played, Color loop, Color mark, Color base, Color text) {
    static final Ink DARK = new Ink("#3d4654", "#ffa63024", "#2ed3a5", "#30363d", "#8b949e");
    static final Ink LIGHT = new Ink("#c4ccd6", "#c2500a1f", "#00785a", "#d0d7de", "#57606a");

    private Ink(String rate, String loop, String mark, String base, String text) {
      this(web(rate), web("#4f8fe6"), web(loop), web(mark), web(base), web(text));
    }
  }

  private static final double MARK_NAME_WIDTH = 120;

  /** Height of the ruler below the rates, and room for one of its times. */
  private static final double RULER_HEIGHT = 16;

  private static final double RULER_TIME_WIDTH = 90;
  private static final double DIGIT_WIDTH = 8;

  /** An end of the marked part is taken hold of within this distance. */
  private static final double HANDLE_REACH = 5;

  private static final double ZOOM_PER_NOTCH = 1.25;

  /** The shortest time that the bar shows, microseconds. */
  private static final long MIN_VIEW_US = 1_000;

  /** What the mouse holds while it is pressed. */
  private enum Grip {
    NEEDLE,
    LOOP_START,
    LOOP_END
  }

  private static final int COLUMN = 3;
  private static final double TICK_HEIGHT = 5;

  /** At least so much of a camera or a scene is drawn, the right end of it empty at first. */
  private static final long MIN_SPAN_US = 5_000_000;

  private static final long GROW_NANOS = 100_000_000;

  /** Rates of a camera or a scene are no nearer to each other than this share of what is drawn. */
  private static final long STEPS = 600;

  private static final long MIN_STEP_US = 10_000;

  private final PlaybackController playback;

  /** The whole profile in the colour of what is to come; marks and loop. */
  private final Canvas canvas = new Canvas();

  /** The whole profile in the colour of what has been; cut off where playback is. */
  private final Canvas played = new Canvas();

  private final Rectangle playedClip = new Rectangle();
  private final Region needle = new Region();
  private final Label hover = Controls.label("", "readout");
  private Ink ink = Ink.DARK;

  /** Events per second over the elapsed timeline, as far as they are known. */
  private final Curve rates = new Curve("", 0);

  private PlayerStatus status;
  private Optional<Reach> reach = Optional.empty();

  /** All that there is, on the elapsed timeline. */
  private long wholeFromUs;

  private long wholeSpanUs = 1;

  /** The part of it that the bar shows. */
  private long fromUs;

  private long spanUs = 1;
  private Grip grip = Grip.NEEDLE;
  private long grownNanos;
  private List<Mark> marks = List.of();
  private List<Mark> ticks = List.of();
  private final BooleanProperty logarithmic = new SimpleBooleanProperty();
  private boolean dirty = true;

  /** A bar without a recording, which seeks by a controller. */
  public SeekBar(PlaybackController playback) {
    this.playback = playback;
    Controls.named(this, "seek-bar", "seek-bar");
    setAccessibleRole(AccessibleRole.SLIDER);
    setAccessibleText("Place in the recording");
    setFocusTraversable(true);
    setMinHeight(44 + RULER_HEIGHT);
    setPrefHeight(44 + RULER_HEIGHT);
    needle.getStyleClass().add("needle");
    needle.setMouseTransparent(true);
    needle.setManaged(false);
    hover.setMouseTransparent(true);
    hover.setManaged(false);
    hover.setVisible(false);
    for (Canvas each : List.of(canvas, played)) {
      each.setManaged(false);
      each.widthProperty().bind(widthProperty());
      each.heightProperty().bind(heightProperty());
    }
    playedClip.heightProperty().bind(heightProperty());
    played.setClip(playedClip);
    Controls.clip(this);
    getChildren().addAll(canvas, played, needle, hover);
    setOnMousePressed(
        event -> {
          grip = gripAt(event.getX());
          drag(event.getX());
        });
    setOnMouseDragged(
        event -> {
          drag(event.getX());
          showHover(event.getX());
        });
    setOnMouseMoved(
        event -> {
          showHover(event.getX());
          setCursor(
              !canSeek()
                  ? Cursor.DEFAULT
                  : gripAt(event.getX()) == Grip.NEEDLE ? Cursor.HAND : Cursor.H_RESIZE);
        });
    setOnScroll(
        event -> {
          double notches = Math.signum(event.getDeltaY());
          if (notches == 0) {
            show(fromUs - Math.round(Math.signum(event.getDeltaX()) * spanUs / 10), spanUs);
          } else {
            zoomAt(event.getX(), Math.pow(ZOOM_PER_NOTCH, -notches));
          }
          event.consume();
        });
    setOnMouseExited(event -> hover.setVisible(false));
    playback.loopProperty().subscribe(() -> dirty = true);
    logarithmic.subscribe(() -> dirty = true);
    widthProperty().subscribe(() -> dirty = true);
    heightProperty().subscribe(() -> dirty = true);
  }

  /** Forgets the recording that was shown. */
  public void clear() {
    rates.clear();
    ticks = List.of();
    status = null;
    reach = Optional.empty();
    dirty = true;
  }

  /** Shows the rate over the whole recording. */
  public void setProfile(RateProfile profile) {
    rates.clear();
    for (int bin = 0; bin <= profile.bins(); bin++) {
      long fromUs = profile.durationUs() * bin / profile.bins();
      rates.add(fromUs, profile.eventsPerSecond(Math.min(bin, profile.bins() - 1)));
    }
    dirty = true;
  }

  /** Whether rates are drawn on a logarithmic scale; else clipped at a percentile. */
  public BooleanProperty logarithmicProperty() {
    return logarithmic;
  }

  /** Marks moments in ascending order, such as triggers, by ticks that the mouse names. */
  public void setTicks(List<Mark> moments) {
    ticks = moments;
    dirty = true;
  }

  /** Draws for a dark window, or for a light one. */
  public void setDark(boolean dark) {
    ink = dark ? Ink.DARK : Ink.LIGHT;
    dirty = true;
  }

  /** Shows where the player is. */
  public void update(PlayerStatus newStatus) {
    status = newStatus;
    reach = playback.reach();
    if (!playback.marks().equals(marks)) {
      marks = playback.marks();
      dirty = true;
    }
    reach.ifPresent(this::follow);
    keepInView(status.elapsedUs());
    double x = Math.rint(xOf(status.elapsedUs()));
    needle.setVisible(canSeek() && isInView(status.elapsedUs()));
    needle.resizeRelocate(x - 1, 0, 2, getHeight() - RULER_HEIGHT);
    playedClip.setWidth(x);
    if (dirty && getWidth() >= COLUMN) {
      dirty = false;
      draw();
    }
  }

  @Override
  public Object queryAccessibleAttribute(AccessibleAttribute attribute, Object... parameters) {
    return switch (attribute) {
      case VALUE -> status == null ? 0.0 : status.elapsedUs() * 1e-6;
      case MIN_VALUE -> wholeFromUs * 1e-6;
      case MAX_VALUE -> (wholeFromUs + wholeSpanUs) * 1e-6;
      case ORIENTATION -> Orientation.HORIZONTAL;
      default -> super.queryAccessibleAttribute(attribute, parameters);
    };
  }

  private boolean canSeek() {
    return status != null && reach.isPresent() && !reach.get().isEmpty();
  }

  /** Goes along with what can be gone to. */
  private void follow(Reach all) {
    long newSpanUs = Math.max(all.grows() ? MIN_SPAN_US : 1, all.toUs() - all.fromUs());
    if (!all.grows()) {
      showWhole(all.fromUs(), newSpanUs);
      return;
    }
    if (rates.lastUs() > all.toUs()) {
      rates.clear();
    }
    if (status.elapsedUs() < rates.lastUs() + Math.max(MIN_STEP_US, newSpanUs / STEPS)) {
      return;
    }
    rates.add(status.elapsedUs(), status.eventRateEps());
    long nanos = System.nanoTime();
    if (nanos - grownNanos > GROW_NANOS) {
      // the picture moves with what is drawn on it
      grownNanos = nanos;
      showWhole(all.fromUs(), newSpanUs);
      dirty = true;
    }
  }

  /** What is zoomed stays where it is; else all is shown. */
  private void showWhole(long newFromUs, long newSpanUs) {
    boolean isZoomed = spanUs < wholeSpanUs;
    if (newFromUs != wholeFromUs || newSpanUs != wholeSpanUs) {
      wholeFromUs = newFromUs;
      wholeSpanUs = newSpanUs;
      show(isZoomed ? fromUs : newFromUs, isZoomed ? spanUs : newSpanUs);
    }
  }

  private void show(long newFromUs, long newSpanUs) {
    spanUs = Math.max(Math.min(MIN_VIEW_US, wholeSpanUs), Math.min(newSpanUs, wholeSpanUs));
    long lastUs = wholeFromUs + wholeSpanUs - spanUs;
    fromUs = Math.max(wholeFromUs, Math.min(newFromUs, lastUs));
    dirty = true;
  }

  private void zoomAt(double x, double factor) {
    long heldUs = placeAt(x);
    long newSpanUs = Math.round(spanUs * factor);
    double share = (heldUs - fromUs) / (double) spanUs;
    show(heldUs - Math.round(share * Math.min(newSpanUs, wholeSpanUs)), newSpanUs);
    showHover(x);
  }

  /** Turns to the part of the recording that playback comes to. */
  private void keepInView(long placeUs) {
    if (status.state() == PlayerStatus.State.PLAYING && !isInView(placeUs)) {
      show(placeUs - spanUs / 10, spanUs);
    }
  }

  private boolean isInView(long placeUs) {
    return placeUs >= fromUs && placeUs <= fromUs + spanUs;
  }

  /** What a press of the mouse takes hold of. */
  private Grip gripAt(double x) {
    Loop loop = playback.loopProperty().get();
    if (loop.on() && isNear(loop.outUs(), x)) {
      return Grip.LOOP_END;
    }
    return loop.on() && isNear(loop.inUs(), x) ? Grip.LOOP_START : Grip.NEEDLE;
  }

  private boolean isNear(OptionalLong placeUs, double x) {
    return placeUs.isPresent()
        && isInView(placeUs.getAsLong())
        && Math.abs(xOf(placeUs.getAsLong()) - x) <= HANDLE_REACH;
  }

  private void drag(double x) {
    if (canSeek() && grip == Grip.NEEDLE) {
      playback.seek(placeAt(x));
    } else if (canSeek()) {
      playback.moveLoopEnd(grip == Grip.LOOP_START, placeAt(x));
    }
  }

  private void showHover(double x) {
    hover.setVisible(canSeek());
    if (canSeek()) {
      hover.setText(Texts.time(placeAt(x), spanUs < 10_000_000) + tickAt(x));
      hover.autosize();
      hover.relocate(
          Math.max(2, Math.min(getWidth() - hover.getWidth() - 2, x - hover.getWidth() / 2)),
          getHeight() - RULER_HEIGHT - hover.getHeight());
    }
  }

  /** Name of the tick nearest to a place on the bar; empty where none is near. */
  private String tickAt(double x) {
    return ticks.stream()
        .filter(tick -> isNear(OptionalLong.of(tick.elapsedUs()), x))
        .min(Comparator.comparingDouble(tick -> Math.abs(xOf(tick.elapsedUs()) - x)))
        .map(tick -> "   " + tick.name())
        .orElse("");
  }

  /** Elapsed time at a place on the bar. */
  private long placeAt(double x) {
    double share = Math.max(0, Math.min(1, x / Math.max(1, getWidth())));
    return fromUs + Math.min(spanUs - 1, Math.round(share * spanUs));
  }

  private double xOf(long elapsedUs) {
    return Math.max(0, Math.min(1, (elapsedUs - fromUs) / (double) spanUs)) * getWidth();
  }

  private void draw() {
    GraphicsContext graphics = canvas.getGraphicsContext2D();
    GraphicsContext over = played.getGraphicsContext2D();
    double width = getWidth();
    double height = getHeight() - RULER_HEIGHT;
    graphics.clearRect(0, 0, width, getHeight());
    over.clearRect(0, 0, width, getHeight());
    drawRuler(graphics, width, height);
    graphics.setFill(ink.base());
    graphics.fillRect(0, height - 1, width, 1);
    Loop loop = playback.loopProperty().get();
    if (loop.on() && (loop.inUs().isPresent() || loop.outUs().isPresent())) {
      double from = xOf(loop.inUs().orElse(0));
      double to = loop.outUs().isPresent() ? xOf(loop.outUs().getAsLong()) : width;
      graphics.setFill(ink.loop());
      graphics.fillRect(from, 0, to - from, height);
      graphics.setFill(ink.mark());
      drawHandle(graphics, loop.inUs(), 0, height);
      drawHandle(graphics, loop.outUs(), -1.5, height);
    }
    double[] columns = rates((int) width / COLUMN);
    drawRates(graphics, columns, ink.rate());
    drawRates(over, columns, ink.played());
    graphics.setFill(ink.mark());
    drawTicks(graphics, width);
    double namedTo = 0;
    for (Mark mark : marks) {
      if (!isInView(mark.elapsedUs())) {
        continue;
      }
      double x = Math.rint(xOf(mark.elapsedUs()));
      graphics.fillPolygon(new double[] {x - 4, x + 4, x}, new double[] {0, 0, 7}, 3);
      graphics.fillRect(x - 0.5, 0, 1, height);
      if (x >= namedTo) {
        graphics.fillText(mark.name(), x + 5, 11, MARK_NAME_WIDTH);
        namedTo = x + 5 + Math.min(MARK_NAME_WIDTH, mark.name().length() * DIGIT_WIDTH);
      }
    }
  }

  /** An end of the marked part, with a grip for the mouse. */
  private void drawHandle(
      GraphicsContext graphics, OptionalLong placeUs, double offset, double height) {
    if (placeUs.isPresent() && isInView(placeUs.getAsLong())) {
      double x = Math.rint(xOf(placeUs.getAsLong())) + offset;
      graphics.fillRect(x, 0, 1.5, height);
      graphics.fillRoundRect(x - 2.5, height / 2 - 8, 6.5, 16, 4, 4);
    }
  }

  /** Times at round places. */
  private void drawRuler(GraphicsContext graphics, double width, double top) {
    Ticks times =
        Ticks.of(fromUs * 1e-6, (fromUs + spanUs) * 1e-6, (int) (width / RULER_TIME_WIDTH));
    graphics.setFill(ink.text());
    for (double seconds : times.values()) {
      double x = Math.rint(xOf(Math.round(seconds * 1e6)));
      graphics.fillRect(x, top, 1, 5);
      String time = rulerTime(seconds, times.step());
      if (x + time.length() * DIGIT_WIDTH < width) {
        graphics.fillText(time, x + 3, top + RULER_HEIGHT - 4, RULER_TIME_WIDTH);
      }
    }
  }

  /** A time with as many decimals as tell it from its neighbours. */
  private static String rulerTime(double seconds, double step) {
    String whole = Texts.time(Math.round(seconds * 1e6), true);
    int decimals = (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    int point = whole.indexOf('.');
    return decimals == 0
        ? whole.substring(0, point)
        : whole.substring(0, Math.min(whole.length(), point + 1 + decimals));
  }

  /** One tick a column at the most, however many moments there are. */
  private void drawTicks(GraphicsContext graphics, double width) {
    double last = -1;
    for (Mark tick : ticks) {
      double x = Math.rint(xOf(tick.elapsedUs()));
      if (isInView(tick.elapsedUs()) && x > last && x <= width) {
        graphics.fillRect(x, 0, 1, TICK_HEIGHT);
        last = x + 1;
      }
    }
  }

  /** The highest rate that was noted in each column, or that of the one before. */
  private double[] rates(int columns) {
    double[] highest = new double[columns];
    int[] filled = {0};
    double[] before = {0};
    rates.paint(
        fromUs,
        fromUs + spanUs,
        columns,
        (from, to, low, high, joined) -> {
          int first = column(from, columns);
          int last = column(to, columns);
          Arrays.fill(highest, Math.min(filled[0], first), first, before[0]);
          for (int column = first; column <= last && column < columns; column++) {
            highest[column] = Math.max(highest[column], high);
          }
          filled[0] = last + 1;
          before[0] = high;
        });
    return highest;
  }

  /** The column of a time, from 0 to one behind the last. */
  private int column(long elapsedUs, int columns) {
    double column = (elapsedUs - fromUs) / (double) spanUs * columns;
    return (int) Math.max(0, Math.min(columns, column));
  }

  private void drawRates(GraphicsContext graphics, double[] columns, Color colour) {
    double[] heights = RateScale.heights(columns, logarithmic.get());
    double bottom = getHeight() - RULER_HEIGHT;
    double usable = bottom - 6;
    graphics.setFill(colour);
    for (int column = 0; column < columns.length; column++) {
      if (columns[column] > 0) {
        double bar = Math.max(1, Math.rint(Math.min(1, heights[column]) * usable));
        graphics.fillRect(column * COLUMN, bottom - bar, COLUMN - 1, bar);
        if (heights[column] > 1) {
          // a gap below the top says that the column is clipped
          graphics.clearRect(column * COLUMN, bottom - bar + 3, COLUMN - 1, 2);
        }
      }
    }
  }
}
