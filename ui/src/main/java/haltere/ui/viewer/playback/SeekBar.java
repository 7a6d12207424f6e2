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
import java.util.regex.Pattern;
import java.util.stream.Stream;
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
 * The time line of the recording: event rate, position, loop, marks and a ruler. A click or a drag
 * seeks, a drag of an end of the loop moves it, the wheel zooms. For a camera or a scene it shows
 * the buffered interval.
 */
public final class SeekBar extends Region {
  /** Colours that a canvas cannot take from the style sheet, for dark and light. */
  private record Colours(Color rate, Color played, Color loop, Color mark, Color base, Color text) {
    static final Colours DARK =
        new Colours("#3d4654", "#ffa63024", "#2ed3a5", "#30363d", "#8b949e");
    static final Colours LIGHT =
        new Colours("#c4ccd6", "#c2500a1f", "#00785a", "#d0d7de", "#57606a");

    private Colours(String rate, String loop, String mark, String base, String text) {
      this(web(rate), web("#4f8fe6"), web(loop), web(mark), web(base), web(text));
    }
  }

  /** Longer names of marks are shortened; the mouse shows them in full. */
  private static final Pattern LONG_NAME = Pattern.compile("(.{23}).{2,}", Pattern.DOTALL);

  /** Height of the ruler below the rates, and room for one of its times. */
  private static final double RULER_HEIGHT = 16;

  private static final double RULER_TIME_WIDTH = 90;
  private static final double DIGIT_WIDTH = 8;

  /** Distance within which an end of the marked part can be dragged. */
  private static final double HANDLE_REACH = 5;

  private static final double ZOOM_PER_NOTCH = 1.25;

  /** The shortest time that the bar shows, microseconds. */
  private static final long MIN_VIEW_US = 1_000;

  /** The dragged part. */
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

  /** Minimum distance of rates of a camera or a scene, as a share of the drawn range. */
  private static final long STEPS = 600;

  private static final long MIN_STEP_US = 10_000;

  private final PlaybackController playback;

  /** The whole profile in the colour of the future; marks and loop. */
  private final Canvas canvas = new Canvas();

  /** The whole profile in the colour of the past; clipped at the present position. */
  private final Canvas played = new Canvas();

  private final Rectangle playedClip = new Rectangle();
  private final Region needle = new Region();
  private final Label hover = Controls.label("", "readout");
  private Colours colours = Colours.DARK;

  /** Known event rates over the elapsed timeline. */
  private final Curve rates = new Curve("", 0);

  private PlayerStatus status;
  private Optional<SeekableRange> reach = Optional.empty();

  /** Start of the full range, on the elapsed timeline. */
  private long fullFromUs;

  private long fullSpanUs = 1;

  /** The part of it that the bar shows. */
  private long fromUs;

  private long spanUs = 1;
  private long followedUs;
  private Grip grip = Grip.NEEDLE;
  private long lastGrowthNanos;
  private List<Mark> marks = List.of();
  private List<Mark> ticks = List.of();
  private final BooleanProperty logarithmic = new SimpleBooleanProperty();
  private boolean dirty = true;

  /** A bar without a recording, which seeks by a controller. */
  public SeekBar(PlaybackController playback) {
    this.playback = playback;
    Controls.named(this, "seek-bar", "seek-bar");
    setAccessibleRole(AccessibleRole.SLIDER);
    setAccessibleText("Position in the recording");
    setFocusTraversable(true);
    setMinHeight(44 + RULER_HEIGHT);
    needle.getStyleClass().add("needle");
    needle.setMouseTransparent(true);
    hover.setMouseTransparent(true);
    hover.setVisible(false);
    for (Canvas each : List.of(canvas, played)) {
      each.widthProperty().bind(widthProperty());
      each.heightProperty().bind(heightProperty());
    }
    playedClip.heightProperty().bind(heightProperty());
    played.setClip(playedClip);
    Controls.clip(this);
    getChildren().addAll(canvas, played, needle, hover);
    getChildren().forEach(child -> child.setManaged(false));
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
    layoutBoundsProperty().subscribe(bounds -> dirty = true);
  }

  /** Clears the recording. */
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
    colours = dark ? Colours.DARK : Colours.LIGHT;
    dirty = true;
  }

  /** Shows the player's position. */
  public void update(PlayerStatus newStatus) {
    status = newStatus;
    reach = playback.reach();
    if (!playback.marks().equals(marks)) {
      marks = playback.marks();
      dirty = true;
    }
    reach.ifPresent(this::follow);
    ensureVisible(status.elapsedUs());
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
      case MIN_VALUE -> fullFromUs * 1e-6;
      case MAX_VALUE -> (fullFromUs + fullSpanUs) * 1e-6;
      case ORIENTATION -> Orientation.HORIZONTAL;
      default -> super.queryAccessibleAttribute(attribute, parameters);
    };
  }

  private boolean canSeek() {
    return status != null && reach.isPresent() && !reach.get().isEmpty();
  }

  private void follow(SeekableRange all) {
    long newSpanUs = Math.max(all.grows() ? MIN_SPAN_US : 1, all.toUs() - all.fromUs());
    if (!all.grows()) {
      setFullRange(all.fromUs(), newSpanUs);
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
    if (nanos - lastGrowthNanos > GROW_NANOS) {
      // the picture moves with the marks on it
      lastGrowthNanos = nanos;
      setFullRange(all.fromUs(), newSpanUs);
      dirty = true;
    }
  }

  /** Sets the full range; a zoomed view is unchanged. */
  private void setFullRange(long newFromUs, long newSpanUs) {
    boolean isZoomed = spanUs < fullSpanUs;
    if (newFromUs != fullFromUs || newSpanUs != fullSpanUs) {
      fullFromUs = newFromUs;
      fullSpanUs = newSpanUs;
      show(isZoomed ? fromUs : newFromUs, isZoomed ? spanUs : newSpanUs);
    }
  }

  private void show(long newFromUs, long newSpanUs) {
    spanUs = Math.max(Math.min(MIN_VIEW_US, fullSpanUs), Math.min(newSpanUs, fullSpanUs));
    long lastUs = fullFromUs + fullSpanUs - spanUs;
    fromUs = Math.max(fullFromUs, Math.min(newFromUs, lastUs));
    dirty = true;
  }

  private void zoomAt(double x, double factor) {
    long heldUs = timeAt(x);
    long newSpanUs = Math.round(spanUs * factor);
    double share = (heldUs - fromUs) / (double) spanUs;
    show(heldUs - Math.round(share * Math.min(newSpanUs, fullSpanUs)), newSpanUs);
    showHover(x);
  }

  /** Scrolls to a position when it changes; in a pause the bar can be moved elsewhere. */
  private void ensureVisible(long positionUs) {
    if (positionUs != followedUs && !isInView(positionUs)) {
      show(positionUs - spanUs / 10, spanUs);
    }
    followedUs = positionUs;
  }

  private boolean isInView(long positionUs) {
    return positionUs >= fromUs && positionUs <= fromUs + spanUs;
  }

  /** The part that a press would drag. */
  private Grip gripAt(double x) {
    Loop loop = playback.loopProperty().get();
    if (loop.on() && isNear(loop.outUs(), x)) {
      return Grip.LOOP_END;
    }
    return loop.on() && isNear(loop.inUs(), x) ? Grip.LOOP_START : Grip.NEEDLE;
  }

  private boolean isNear(OptionalLong positionUs, double x) {
    return positionUs.isPresent()
        && isInView(positionUs.getAsLong())
        && Math.abs(xOf(positionUs.getAsLong()) - x) <= HANDLE_REACH;
  }

  private void drag(double x) {
    if (canSeek() && grip == Grip.NEEDLE) {
      playback.seek(timeAt(x));
    } else if (canSeek()) {
      playback.moveLoopEnd(grip == Grip.LOOP_START, timeAt(x));
    }
  }

  private void showHover(double x) {
    hover.setVisible(canSeek());
    if (canSeek()) {
      hover.setText(Texts.time(timeAt(x), spanUs < 10_000_000) + nameAt(x));
      hover.autosize();
      hover.relocate(
          Math.max(2, Math.min(getWidth() - hover.getWidth() - 2, x - hover.getWidth() / 2)),
          getHeight() - RULER_HEIGHT - hover.getHeight());
    }
  }

  /** Name of the mark or tick nearest to a position on the bar; empty if none is near. */
  private String nameAt(double x) {
    return Stream.concat(playback.marks().stream(), ticks.stream())
        .filter(tick -> isNear(OptionalLong.of(tick.elapsedUs()), x))
        .min(Comparator.comparingDouble(tick -> Math.abs(xOf(tick.elapsedUs()) - x)))
        .map(tick -> "   " + tick.name())
        .orElse("");
  }

  /** Elapsed time at a position on the bar. */
  private long timeAt(double x) {
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
    graphics.setFill(colours.base());
    graphics.fillRect(0, height - 1, width, 1);
    Loop loop = playback.loopProperty().get();
    if (loop.on() && (loop.inUs().isPresent() || loop.outUs().isPresent())) {
      double from = xOf(loop.inUs().orElse(0));
      double to = loop.outUs().isPresent() ? xOf(loop.outUs().getAsLong()) : width;
      graphics.setFill(colours.loop());
      graphics.fillRect(from, 0, to - from, height);
      graphics.setFill(colours.mark());
      drawHandle(graphics, loop.inUs(), 0, height);
      drawHandle(graphics, loop.outUs(), -1.5, height);
    }
    double[] columns = rates((int) width / COLUMN);
    drawRates(graphics, columns, colours.rate());
    drawRates(over, columns, colours.played());
    graphics.setFill(colours.mark());
    drawTicks(graphics, width);
    double namedTo = 0;
    double nameY = ticks.isEmpty() ? 11 : 11 + TICK_HEIGHT;
    for (Mark mark : marks.stream().filter(each -> isInView(each.elapsedUs())).toList()) {
      double x = Math.rint(xOf(mark.elapsedUs()));
      graphics.fillPolygon(new double[] {x - 4, x + 4, x}, new double[] {0, 0, 7}, 3);
      graphics.fillRect(x - 0.5, 0, 1, height);
      String name = LONG_NAME.matcher(mark.name()).replaceAll("$1\u2026");
      double nameWidth = name.length() * DIGIT_WIDTH;
      double nameX = x + 5 + nameWidth <= width ? x + 5 : x - 5 - nameWidth;
      if (nameX >= namedTo) {
        graphics.fillText(name, nameX, nameY, nameWidth);
        namedTo = nameX + nameWidth;
      }
    }
  }

  /** An end of the marked part, with a grip for the mouse. */
  private void drawHandle(
      GraphicsContext graphics, OptionalLong positionUs, double offset, double height) {
    if (positionUs.isPresent() && isInView(positionUs.getAsLong())) {
      double x = Math.rint(xOf(positionUs.getAsLong())) + offset;
      graphics.fillRect(x, 0, 1.5, height);
      graphics.fillRoundRect(x - 2.5, height / 2 - 8, 6.5, 16, 4, 4);
    }
  }

  /** Times at round places. */
  private void drawRuler(GraphicsContext graphics, double width, double top) {
    Ticks times =
        Ticks.of(fromUs * 1e-6, (fromUs + spanUs) * 1e-6, (int) (width / RULER_TIME_WIDTH));
    graphics.setFill(colours.text());
    for (double seconds : times.values()) {
      double x = Math.rint(xOf(Math.round(seconds * 1e6)));
      graphics.fillRect(x, top, 1, 5);
      String time = rulerTime(seconds, times.step());
      if (x + time.length() * DIGIT_WIDTH < width) {
        graphics.fillText(time, x + 3, top + RULER_HEIGHT - 4, RULER_TIME_WIDTH);
      }
    }
  }

  /** A time with as many decimals as distinguish it from its neighbours. */
  private static String rulerTime(double seconds, double step) {
    String whole = Texts.time(Math.round(seconds * 1e6), true);
    int decimals = (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    int point = whole.indexOf('.');
    int end = decimals == 0 ? point : point + 1 + decimals;
    return whole.substring(0, Math.min(whole.length(), end));
  }

  /** At most one tick in each column, for any number of moments. */
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
