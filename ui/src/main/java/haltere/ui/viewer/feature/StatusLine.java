package haltere.ui.viewer.feature;

import atlantafx.base.theme.Styles;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Windows;
import javafx.css.PseudoClass;
import javafx.geometry.Pos;
import javafx.scene.AccessibleRole;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.TextArea;
import javafx.scene.layout.HBox;

/**
 * The bottom line: problems, delays or the open source at the left; time, rate, speed, frames and
 * losses at the right.
 */
public final class StatusLine extends HBox {
  private static final PseudoClass ERROR = PseudoClass.getPseudoClass("error");

  /** Below this width, pixels, how often the screen is drawn gives way. */
  private static final double WIDE_PX = 760;

  /** Duration of a run-up from which on it is reported. */
  private static final long RUN_UP_NANOS = 300_000_000;

  private static final String SPEED_HELP = "Recording time per real time that playback achieves.";

  private final Label message = Controls.named(new Label(), "status-message");
  private final Button dismiss;
  private final Button more;
  private final Label time = number("status-time", 150, "Time on the recording's own clock");
  private final Label rate = number("status-rate", 90, "Events per second of recording time");
  private final Label speed = number("status-speed", 90, SPEED_HELP);
  private final Label frames =
      number("status-frames", 60, "Pictures shown per second of real time");
  private final Label dropped =
      number(
          "status-dropped",
          USE_PREF_SIZE,
          "Events that were lost (off the sensor, by the source, or in a filter that failed), and"
              + " pictures that a newer one replaced before the screen could show them");
  private final Label live =
      number(
          "status-live",
          0,
          "Of the camera: transfers that wait for this program, and the time from a transfer's"
              + " arrival to the end of its work");
  private long runUpNanos;
  private long lostByCamera;
  private boolean silent;
  private String error = "";
  private String refusal = "";
  private String details = "";
  private long playerFailures;
  private String source = "";
  private String activity = "";
  private PlayerStatus status;
  private boolean reverse;

  /** An empty line. */
  public StatusLine() {
    Controls.named(this, "status-line", "status-line");
    setAlignment(Pos.CENTER_LEFT);
    message.setAccessibleRole(AccessibleRole.TEXT);
    message.setMinWidth(0);
    Controls.growing(message);
    dismiss =
        Controls.button(
            "dismiss", Icons.REMOVE, "Dismiss the message", this::clearError, Styles.SMALL);
    more =
        Controls.button(
            "details", Icons.MORE, "All that is known of this", this::showDetails, Styles.SMALL);
    getChildren().addAll(message, more, dismiss, live, dropped, frames, speed, time, rate);
    setLive("", 0, false);
    clearError();
  }

  /** Shows a problem in a line, and its details on request. */
  public void showProblem(Throwable problem) {
    showError(Texts.oneLine(problem));
    details = Texts.details(problem);
  }

  /** Shows a problem until it is dismissed or another source is opened. */
  public void showError(String line) {
    error = line;
    // the line may be cut off
    details = line;
    showMessage();
  }

  /** Shows why a command or an entry is refused, until the next command; empty if none is. */
  public void showRefusal(String line) {
    if (!line.isEmpty() || error.equals(refusal)) {
      showError(line);
    }
    refusal = line;
  }

  /**
   * Shows the state of a live camera, which may lose events in a pause; empty text for none. While
   * it sends nothing, the last rate and speed are not shown.
   */
  public void setLive(String words, long lostEvents, boolean isSilent) {
    lostByCamera = lostEvents;
    silent = isSilent;
    live.setText(words);
    live.setManaged(!words.isEmpty());
  }

  /** Clears the problem and the activity. */
  public void clearError() {
    error = "";
    activity = "";
    showMessage();
  }

  /** Shows the open source. */
  void setSource(String words) {
    source = words;
    playerFailures = 0;
    status = null;
    clearError();
  }

  /** Shows an activity, until {@link #setSource} or an error. */
  public void setActivity(String words) {
    activity = words;
    showMessage();
  }

  /** Clears an activity, if it is the shown one. */
  void endActivity(String words) {
    if (activity.equals(words)) {
      setActivity("");
    }
  }

  /** Shows the player's status; called a few times a second. */
  void update(
      PlayerStatus newStatus, boolean isReverse, double framesPerSecond, long conflatedFrames) {
    status = newStatus;
    reverse = isReverse;
    if (status.failures() != playerFailures) {
      playerFailures = status.failures();
      showError(status.message());
    }
    boolean timed = status.timeUs() != StreamNotification.NO_TIME_US;
    if (timed || !isReverse) {
      // backwards, numbers of the last shown moment remain until the next is computed
      time.setText(timed ? "t " + status.timeUs() + " \u00b5s" : "");
      rate.setText(silent ? "" : Texts.rate(status.eventRateEps()));
    }
    boolean playing = status.state() == State.PLAYING && !silent;
    Controls.show(playing, speed);
    Controls.show(playing && getWidth() > WIDE_PX, frames);
    speed.setText(playing ? Texts.reached(status) : "");
    Controls.help(speed, SPEED_HELP + " " + Texts.limit(status));
    if (status.runUpUs() == 0) {
      runUpNanos = 0;
    } else if (runUpNanos == 0) {
      runUpNanos = System.nanoTime();
    }
    frames.setText(playing ? Math.round(framesPerSecond) + " fps" : "");
    dropped.setText(
        Texts.count(Math.max(status.droppedEvents(), lostByCamera))
            + " lost"
            + (playing ? ", " + Texts.count(conflatedFrames) + " skipped in display" : ""));
    showMessage();
  }

  private void showMessage() {
    boolean isError = !error.isEmpty();
    String text = source;
    if (isError) {
      text = error;
    } else if (!activity.isEmpty()) {
      text = activity;
    } else if (runUpNanos != 0 && System.nanoTime() - runUpNanos > RUN_UP_NANOS) {
      text = "Computing this moment, " + Texts.duration(status.runUpUs()) + " to go \u2026";
    } else if (status != null && status.state() == State.ENDED) {
      text = source + " \u2013 end";
    } else if (status != null && status.state() == State.PAUSED) {
      text = source + (reverse ? " \u2013 backwards" : " \u2013 paused");
    }
    message.setText(text);
    Controls.help(message, text);
    message.pseudoClassStateChanged(ERROR, isError);
    Controls.show(isError, dismiss, more);
  }

  private void showDetails() {
    TextArea text = Controls.named(new TextArea(details), "problem-details");
    text.setAccessibleText("Details of the problem");
    text.setEditable(false);
    text.setWrapText(true);
    text.setPrefSize(640, 300);
    Windows.showContent(getScene().getWindow(), "Details", text);
  }

  private static Label number(String id, double width, String help) {
    Label label = Controls.named(new Label(), id);
    label.setMinWidth(width);
    label.setAlignment(Pos.CENTER_RIGHT);
    Controls.help(label, help);
    label.getStyleClass().add("status-number");
    return label;
  }
}
