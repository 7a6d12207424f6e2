package haltere.ui.viewer.picture;

import haltere.core.playback.PlayerStatus;
import haltere.ui.viewer.controls.Controls;
import java.util.OptionalInt;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/**
 * Says over the picture which share of the events the filters hide, and shows them on request.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class HiddenEvents extends HBox {
  /** Time over which the share is measured, real time. */
  public static final long BETWEEN_NANOS = 500_000_000;

  /** Events that the share needs at least. */
  private static final long MIN_EVENTS = 200;

  private final BooleanProperty shown;
  private final Label share = Controls.named(new Label(), "hidden-share");
  private final Hyperlink change = Controls.named(new Hyperlink(), "show-hidden");
  private PlayerStatus from;
  private OptionalInt percent = OptionalInt.empty();

  /**
   * Words that are not seen until events are hidden; the switch shows the events before the
   * filters.
   */
  public HiddenEvents(BooleanProperty shown) {
    super(4);
    this.shown = shown;
    Controls.named(this, "hidden-events", "readout", "hidden-events");
    setAlignment(Pos.CENTER_LEFT);
    setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
    change.setAccessibleText("Show or hide the events that filters remove");
    change.setOnAction(event -> shown.set(!shown.get()));
    getChildren().addAll(share, change);
    shown.subscribe((was, is) -> say());
    say();
  }

  /** Forgets what was measured, for another recording. */
  public void clear() {
    from = null;
    percent = OptionalInt.empty();
    say();
  }

  /** Measures the share of events that the filters removed since the last call, if any is on. */
  public void update(PlayerStatus now, boolean anyFilter) {
    if (!anyFilter) {
      clear();
    } else if (from == null || now.eventsIn() < from.eventsIn()) {
      from = now;
    } else if (now.eventsIn() - from.eventsIn() >= MIN_EVENTS) {
      long in = now.eventsIn() - from.eventsIn();
      long hidden = in - (now.eventsOut() - from.eventsOut());
      percent = OptionalInt.of((int) Math.round(100.0 * Math.max(0, hidden) / in));
      from = now;
      say();
    }
  }

  private void say() {
    boolean any = percent.orElse(0) > 0;
    setVisible(any);
    if (any) {
      int all = percent.getAsInt();
      share.setText(
          shown.get()
              ? "All events shown; " + all + " % filtered out,"
              : all + " % of the events hidden,");
      change.setText(shown.get() ? "hide" : "show");
    }
  }
}
