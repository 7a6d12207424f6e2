package haltere.ui.viewer.playback;

import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanBinding;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.Separator;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** Buttons of playback: transport, speed, slices, loop, marks, and the time. */
public final class TransportBar extends HBox {
  /** Distance to the newest events that counts as live. */
  private static final long NOW_US = 100_000;

  private static final String NOT_SEEKABLE = "This source cannot go back: none of it is buffered.";

  private final PlaybackController playback;
  private final Button play;
  private final Node playIcon = Icons.PLAY.node();
  private final Node pauseIcon = Icons.PAUSE.node();

  /** Below this width, pixels, the time until the end and the lines between groups give way. */
  private static final double WIDE_PX = 880;

  /** Below this width, pixels, so do buttons whose work is in menus and on keys. */
  private static final double NARROW_PX = 740;

  private final MenuButton speed = Controls.named(new MenuButton(), "speed");
  private final ToggleButton loop = Controls.toggle("loop", Icons.LOOP, "Repeat at the end (L)");
  private final HBox speedRow;
  private final Button back;
  private final Button markIn;
  private final Button markOut;
  private final ToggleButton backwards =
      Controls.toggle("play-backwards", Icons.BACKWARDS, "Play backwards (Shift+Space)");
  private final HBox tools = Controls.row(0);
  private final Label elapsed = Controls.named(new Label(), "elapsed", "time");
  private final Label remaining =
      Controls.named(new Label(), "remaining", "time", "time-remaining");

  /** The buttons of a controller. */
  public TransportBar(PlaybackController playback) {
    this.playback = playback;
    getStyleClass().add("transport-bar");
    setAlignment(Pos.CENTER_LEFT);
    play = Controls.button("play", Icons.PAUSE, "Pause (Space)", playback::togglePause);
    play.setGraphic(pauseIcon);
    back =
        Controls.button(
            "step-back", Icons.STEP_BACK, "One slice back (,)", () -> playback.step(-1));
    markIn = Controls.button("mark-in", Icons.MARK_IN, "Start the loop here (I)", playback::markIn);
    markOut =
        Controls.button("mark-out", Icons.MARK_OUT, "End the loop here (O)", playback::markOut);
    speed.setAccessibleText("Speed");
    Controls.help(
        speed, "Recording time per real time. F and S take the next higher and lower speed.");
    List<Double> speeds = new ArrayList<>(PlaybackController.SPEEDS);
    speeds.add(Double.POSITIVE_INFINITY);
    for (double preset : speeds) {
      Runnable choose = () -> playback.setSpeed(preset);
      speed.getItems().add(Controls.item(null, Texts.speed(preset), choose));
    }
    backwards.setOnAction(event -> playback.toggleReverse());
    playback.reverseProperty().subscribe((was, is) -> backwards.setSelected(is));
    playback.speedProperty().subscribe(now -> speed.setText(Texts.speed(now)));
    for (Region kept : List.of(speed, elapsed, remaining)) {
      kept.setMinWidth(Region.USE_PREF_SIZE);
    }
    BooleanBinding isWide = widthProperty().greaterThan(WIDE_PX);
    Controls.bindVisible(isWide, remaining);
    Button slower = Controls.button("slower", Icons.SLOWER, "Slower (S)", playback::slower);
    Button faster = Controls.button("faster", Icons.FASTER, "Faster (F)", playback::faster);
    BooleanBinding isMedium = widthProperty().greaterThan(NARROW_PX);
    Controls.bindVisible(isMedium, slower, faster, markIn, markOut);
    tools
        .minWidthProperty()
        .bind(Bindings.when(isMedium).then(USE_PREF_SIZE).otherwise(USE_COMPUTED_SIZE));
    speedRow = Controls.row(4, slower, speed, faster);
    loop.setOnAction(event -> playback.setLooping(loop.isSelected()));
    playback.loopProperty().subscribe(now -> loop.setSelected(now.on()));
    Controls.help(elapsed, "Time since the start");
    Controls.help(remaining, "Time until the end, or until the newest event");
    getChildren()
        .addAll(
            Controls.button("rewind", Icons.REWIND, "Back to the start (R)", playback::rewind),
            Controls.place(back),
            Controls.place(backwards),
            play,
            Controls.button(
                "step-forward",
                Icons.STEP_FORWARD,
                "One slice forward (.)",
                () -> playback.step(1)),
            new Separator(Orientation.VERTICAL),
            Controls.place(speedRow),
            new Separator(Orientation.VERTICAL),
            new SlicingField(playback),
            new Separator(Orientation.VERTICAL),
            Controls.place(loop),
            Controls.place(markIn),
            Controls.place(markOut),
            Controls.button("mark", Icons.MARK, "Set a mark here (M)", playback::mark),
            new Separator(Orientation.VERTICAL),
            Controls.button("reset-filters", Icons.RESET, "Reset all filters (Z)", playback::reset),
            tools,
            Controls.growing(new Region()),
            elapsed,
            remaining);
    getChildren().stream()
        .filter(Separator.class::isInstance)
        .forEach(separator -> Controls.bindVisible(isWide, separator));
    setObstacle("Nothing is open.");
  }

  private void setObstacle(String text) {
    Controls.unless(text, back, backwards, loop, markIn, markOut);
  }

  /** Adds a control behind those of playback. */
  public void addTool(Node tool) {
    tools.getChildren().add(tool);
  }

  /** Shows the player's status. */
  public void update(PlayerStatus status) {
    Optional<SeekableRange> reach = playback.reach();
    boolean playing = status.state() == State.PLAYING || playback.reverseProperty().get();
    Node icon = playing ? pauseIcon : playIcon;
    if (play.getGraphic() != icon) {
      String help = playing ? "Pause (Space)" : "Play (Space)";
      play.setGraphic(icon);
      Controls.help(play, help);
      play.setAccessibleText(help);
    }
    boolean fine = status.sliceUs() < 1000;
    elapsed.setText(Texts.time(status.elapsedUs(), fine));
    long behindUs = reach.map(all -> all.toUs() - status.elapsedUs()).orElse(0L);
    boolean newest = reach.isEmpty() || reach.get().grows() && behindUs < status.sliceUs() + NOW_US;
    remaining.setText(newest ? "" : "/ " + Texts.time(-behindUs, fine));
    setObstacle(reach.isEmpty() ? NOT_SEEKABLE : "");
    Controls.unless(playback.isLive() ? "A camera plays in real time." : "", speedRow);
  }
}
