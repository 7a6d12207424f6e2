package haltere.ui.viewer;

import haltere.core.format.RateProfile;
import haltere.core.playback.Loop;
import haltere.core.playback.Mark;
import haltere.core.playback.PlayerStatus;
import java.util.List;
import java.util.Optional;
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
 * the marks. A click or a drag seeks. For a source without end the rate of the last while is drawn.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SeekBar extends Region {
  /** Colours that a canvas cannot take from the style sheet, for dark and light. */
  private record Ink(Color rate, Color played, Color loop, Color mark, Color base) {
    static final Ink DARK =
        new Ink(
            Color.web("#3d4654"),
            Color.web("#4f8fe6"),
            Color.web("#ffa630", 0.14),
            Color.web("#2ed3a5"),
            Color.web("#30363d"));
    static final Ink LIGHT =
        new Ink(
            Color.web("#c4ccd6"),
            Color.web("#4f8fe6"),
            Color.web("#c2500a", 0.12),
            Color.web("#00785a"),
            Color.web("#d0d7de"));
  }

  private static final int HISTORY = 400;
  private static final double MARK_NAME_WIDTH = 120;
  private static final long HISTORY_NANOS = 100_000_000;

  private final PlaybackController playback;

  /** The whole profile in the colour of what is to come; marks and loop. */
  private final Canvas canvas = new Canvas();

  /** The whole profile in the colour of what has been; cut off where playback is. */
  private final Canvas played = new Canvas();

  private final Rectangle playedClip = new Rectangle();
  private final Region needle = new Region();
  private final Label hover = new Label();
  private Ink ink = Ink.DARK;
  private Optional<RateProfile> profile = Optional.empty();
  private final double[] history = new double[HISTORY];
  private int historyLength;
  private long lastHistoryUs = Long.MIN_VALUE;
  private PlayerStatus status;
  private List<Mark> marks = List.of();
  private Loop loop = Loop.OFF;
  private long historyNanos;
  private boolean dirty = true;

  SeekBar(PlaybackController playback) {
    this.playback = playback;
    getStyleClass().add("seek-bar");
    setId("seek-bar");
    setAccessibleRole(AccessibleRole.SLIDER);
    setAccessibleText("Place in the recording");
    setMinHeight(44);
    setPrefHeight(44);
    needle.getStyleClass().add("needle");
    needle.setMouseTransparent(true);
    needle.setManaged(false);
    hover.getStyleClass().add("readout");
    hover.setMouseTransparent(true);
    hover.setManaged(false);
    hover.setVisible(false);
    canvas.setManaged(false);
    played.setManaged(false);
    played.setClip(playedClip);
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(widthProperty());
    clip.heightProperty().bind(heightProperty());
    setClip(clip);
    getChildren().addAll(canvas, played, needle, hover);
    setOnMousePressed(event -> seek(event.getX()));
    setOnMouseDragged(
        event -> {
          seek(event.getX());
          showHover(event.getX());
        });
    setOnMouseMoved(event -> showHover(event.getX()));
    setOnMouseExited(event -> hover.setVisible(false));
    playback
        .loopProperty()
        .addListener(
            (property, old, now) -> {
              loop = now;
              dirty = true;
            });
    loop = playback.loopProperty().get();
  }

  /** Forgets the recording that was shown. */
  void clear() {
    profile = Optional.empty();
    historyLength = 0;
    lastHistoryUs = Long.MIN_VALUE;
    status = null;
    dirty = true;
  }

  /** Shows the rate over the whole recording. */
  void setProfile(RateProfile newProfile) {
    profile = Optional.of(newProfile);
    dirty = true;
  }

  boolean hasProfile() {
    return profile.isPresent();
  }

  void setDark(boolean dark) {
    ink = dark ? Ink.DARK : Ink.LIGHT;
    dirty = true;
  }

  /** Shows where the player is. */
  void update(PlayerStatus newStatus, List<Mark> newMarks) {
    status = newStatus;
    if (!newMarks.equals(marks)) {
      marks = newMarks;
      dirty = true;
    }
    boolean endless = status.durationUs() < 0;
    setCursor(endless ? Cursor.DEFAULT : Cursor.HAND);
    if (endless) {
      remember();
    }
    double x = endless ? getWidth() : Math.rint(xOf(status.elapsedUs()));
    needle.setVisible(!endless);
    needle.resizeRelocate(x - 1, 0, 2, getHeight());
    playedClip.setWidth(x);
    if (dirty) {
      dirty = false;
      draw();
    }
  }

  @Override
  protected void layoutChildren() {
    if (canvas.getWidth() != getWidth() || canvas.getHeight() != getHeight()) {
      canvas.setWidth(getWidth());
      canvas.setHeight(getHeight());
      played.setWidth(getWidth());
      played.setHeight(getHeight());
      playedClip.setHeight(getHeight());
      dirty = true;
    }
  }

  private void remember() {
    if (status.elapsedUs() < lastHistoryUs) {
      historyLength = 0;
    }
    long nanos = System.nanoTime();
    if (status.elapsedUs() != lastHistoryUs && nanos - historyNanos > HISTORY_NANOS) {
      historyNanos = nanos;
      lastHistoryUs = status.elapsedUs();
      history[historyLength++ % HISTORY] = status.eventRateEps();
      dirty = true;
    }
  }

  private void seek(double x) {
    if (status != null && status.durationUs() > 0) {
      playback.seek(placeAt(x));
    }
  }

  private void showHover(double x) {
    boolean known = status != null && status.durationUs() > 0;
    hover.setVisible(known);
    if (known) {
      hover.setText(Texts.time(placeAt(x), status.durationUs() < 10_000_000));
      hover.autosize();
      hover.relocate(
          Math.max(2, Math.min(getWidth() - hover.getWidth() - 2, x - hover.getWidth() / 2)), 3);
    }
  }

  /** Elapsed time at a place on the bar. */
  private long placeAt(double x) {
    double share = Math.max(0, Math.min(1, x / Math.max(1, getWidth())));
    return Math.min(status.durationUs() - 1, Math.round(share * status.durationUs()));
  }

  private double xOf(long elapsedUs) {
    return status == null || status.durationUs() <= 0
        ? 0
        : Math.max(0, Math.min(1, elapsedUs / (double) status.durationUs())) * getWidth();
  }

  private void draw() {
    GraphicsContext graphics = canvas.getGraphicsContext2D();
    GraphicsContext over = played.getGraphicsContext2D();
    double width = getWidth();
    double height = getHeight();
    graphics.clearRect(0, 0, width, height);
    over.clearRect(0, 0, width, height);
    graphics.setFill(ink.base());
    graphics.fillRect(0, height - 1, width, 1);
    if (status != null && status.durationUs() < 0) {
      drawHistory(over);
      return;
    }
    if (loop.on() && (loop.inUs().isPresent() || loop.outUs().isPresent())) {
      double from = xOf(loop.inUs().orElse(0));
      double to = loop.outUs().isPresent() ? xOf(loop.outUs().getAsLong()) : width;
      graphics.setFill(ink.loop());
      graphics.fillRect(from, 0, to - from, height);
      graphics.setFill(ink.mark());
      graphics.fillRect(Math.rint(from), 0, 1.5, height);
      graphics.fillRect(Math.rint(to) - 1.5, 0, 1.5, height);
    }
    profile.ifPresent(
        rates -> {
          drawProfile(graphics, rates, ink.rate());
          drawProfile(over, rates, ink.played());
        });
    graphics.setFill(ink.mark());
    for (Mark mark : marks) {
      double x = Math.rint(xOf(mark.elapsedUs()));
      graphics.fillPolygon(new double[] {x - 4, x + 4, x}, new double[] {0, 0, 7}, 3);
      graphics.fillRect(x - 0.5, 0, 1, height);
      graphics.fillText(mark.name(), x + 5, 11, MARK_NAME_WIDTH);
    }
  }

  private void drawProfile(GraphicsContext graphics, RateProfile rates, Color colour) {
    double highest = 0;
    for (int bin = 0; bin < rates.bins(); bin++) {
      highest = Math.max(highest, rates.eventsPerSecond(bin));
    }
    double usable = getHeight() - 6;
    int columns = (int) getWidth();
    graphics.setFill(colour);
    for (int column = 0; column < columns; column += 3) {
      int from = (int) ((long) column * rates.bins() / columns);
      int to = Math.max(from + 1, (int) ((long) (column + 3) * rates.bins() / columns));
      double rate = 0;
      for (int bin = from; bin < Math.min(to, rates.bins()); bin++) {
        rate = Math.max(rate, rates.eventsPerSecond(bin));
      }
      if (rate > 0) {
        double bar = Math.max(1, Math.rint(rate / highest * usable));
        graphics.fillRect(column, getHeight() - bar, 2, bar);
      }
    }
  }

  private void drawHistory(GraphicsContext graphics) {
    int shown = Math.min(historyLength, HISTORY);
    double highest = 1;
    for (int i = 0; i < shown; i++) {
      highest = Math.max(highest, history[i]);
    }
    double usable = getHeight() - 6;
    graphics.setFill(ink.played());
    for (int i = 0; i < shown; i++) {
      double bar = Math.rint(history[(historyLength - shown + i) % HISTORY] / highest * usable);
      double x = getWidth() - (shown - i) * 3.0;
      if (x >= 0 && bar > 0) {
        graphics.fillRect(Math.rint(x), getHeight() - bar, 2, bar);
      }
    }
  }
}
