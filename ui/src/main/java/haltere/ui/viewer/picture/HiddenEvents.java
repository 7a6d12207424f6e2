package haltere.ui.viewer.picture;

import haltere.ui.viewer.controls.Controls;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.VBox;

/** Shows the share of events hidden by filters, and the events on request. */
public final class HiddenEvents extends VBox {
  /** Time over which the share is measured, real time. */
  public static final long BETWEEN_NANOS = 500_000_000;

  private final BooleanProperty shown;
  private final Label share = Controls.named(new Label(), "hidden-share");
  private final Hyperlink change = Controls.named(new Hyperlink(), "show-hidden");
  private int percent;

  /**
   * Words that are not seen until events are hidden; the switch shows the events before the
   * filters.
   */
  public HiddenEvents(BooleanProperty shown) {
    this.shown = shown;
    Controls.named(this, "hidden-events", "hidden-events");
    setAlignment(Pos.TOP_CENTER);
    Controls.help(this, "Share of the events that the filters remove");
    change.setAccessibleText("Show or hide the events that filters remove");
    change.setOnAction(event -> shown.set(!shown.get()));
    getChildren().addAll(share, change);
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
    share.setText(percent + (shown.get() ? " %\nfiltered," : " %\nhidden,"));
    change.setText(shown.get() ? "hide" : "show");
  }
}
