package haltere.ui.viewer.picture;

import haltere.ui.viewer.controls.Controls;
import javafx.beans.property.BooleanProperty;
import javafx.scene.control.Hyperlink;
import javafx.scene.layout.Region;

/** The share of events hidden by filters; a click shows the events before the filters. */
public final class HiddenEvents extends Hyperlink {
  /** Time over which the share is measured, real time. */
  public static final long BETWEEN_NANOS = 500_000_000;

  private final BooleanProperty shown;
  private int percent;

  /** Words that are not seen until events are hidden; the switch shows them. */
  public HiddenEvents(BooleanProperty shown) {
    this.shown = shown;
    Controls.named(this, "hidden-events", "hidden-events");
    Controls.help(this, "Share of the events that the filters remove; shows or hides them");
    setAccessibleText("Show or hide the events that filters remove");
    setMinHeight(Region.USE_PREF_SIZE);
    setMaxWidth(Double.MAX_VALUE);
    setOnAction(event -> shown.set(!shown.get()));
    shown.subscribe((was, is) -> say());
    say();
  }

  /** Clears the measurement, for another recording. */
  public void clear() {
    percent = 0;
    say();
  }

  /** Shows the share of a display. */
  public void update(DisplaySink display) {
    percent = display.passed.takePercentHidden().orElse(percent);
    say();
  }

  private void say() {
    Controls.show(percent > 0, this);
    setText(percent + (shown.get() ? " %\nshown" : " %\nhidden"));
    setVisited(false);
  }
}
