package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.session.InitialView;
import haltere.ui.viewer.session.ViewerSession;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;

/**
 * Starts a tethered fly in slow motion once its wings have been found in real time, and shows a
 * caption until it is clicked.
 */
final class FlyStartFeature extends WindowFeature {
  /** Recording time per real time: a stroke of 5 ms takes half a second. */
  static final double SLOW_MOTION = 0.01;

  /** The wing tracker searches for 35 ms, then both wings settle. */
  private static final long SEARCH_US = 80_000;

  private final BooleanProperty captionEnabled = new SimpleBooleanProperty(true);
  private final Button caption =
      Controls.named(new Button("", Icons.REMOVE.node()), "fly-caption", "caption");
  private boolean searching;
  private boolean isFly;
  private double speedBefore = 1;

  @Override
  protected void install() {
    caption.setWrapText(true);
    caption.setContentDisplay(ContentDisplay.RIGHT);
    // the caption's height follows its number of lines
    caption
        .widthProperty()
        .subscribe(wide -> caption.setMinHeight(caption.prefHeight(wide.doubleValue())));
    caption.setOnAction(event -> captionEnabled.set(false));
    window.panels().addAbovePicture(caption);
    window.settings().keep("flyCaption", captionEnabled);
    window.onSession(this::begin);
    // a speed chosen during the search remains, even if it is the same
    window.playback().speedProperty().subscribe(() -> searching = false);
    window.panels().onPulse(() -> window.ifOpen(this::pulse));
    captionEnabled.subscribe(enabled -> showCaption());
    window.display().onChange(this::showCaption);
  }

  private void begin(ViewerSession made) {
    boolean fly = made.request().start() == InitialView.FLY;
    double speed = window.playback().speedProperty().get();
    if (fly && !isFly) {
      speedBefore = speed;
    }
    if (fly || isFly && speed == SLOW_MOTION) {
      window.playback().setSpeed(fly ? 1 : speedBefore);
    }
    isFly = fly;
    searching = fly;
    showCaption();
  }

  private void pulse(ViewerSession open) {
    if (searching && open.player().status().elapsedUs() >= SEARCH_US) {
      window.playback().setSpeed(SLOW_MOTION);
    }
  }

  private void showCaption() {
    Controls.show(isFly && captionEnabled.get(), caption);
    DisplayOptions shown = window.display().options();
    caption.setText(
        "Simulated tethered fly, seen from above"
            + (shown.mode() == DisplayMode.POLARITY && shown.colours().equals(ColourMap.DARK)
                ? "; orange: brighter (ON), blue: darker (OFF)"
                : ""));
    caption.setAccessibleText("Dismiss the caption: " + caption.getText());
  }
}
