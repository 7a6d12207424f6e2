package haltere.ui.viewer.picture;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterTiming;
import haltere.ui.viewer.controls.Controls;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;

/** Says over the picture which share of the events the filters hide, and shows them on request. */
public final class HiddenEvents extends HBox {
  /** Time over which the share is measured, real time. */
  public static final long BETWEEN_NANOS = 500_000_000;

  /** Events that the share needs at least. */
  private static final long MIN_EVENTS = 200;

  private final BooleanProperty shown;
  private final Label share = Controls.named(new Label(), "hidden-share");
  private final Hyperlink change = Controls.named(new Hyperlink(), "show-hidden");
  private Map<ChainStage, FilterTiming> from = Map.of();
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
    from = Map.of();
    percent = OptionalInt.empty();
    say();
  }

  /**
   * Measures the share of events that the stages that are on removed since the last call, also in
   * the run to a moment that is shown in a pause.
   */
  public void update(List<ChainStage> on) {
    if (on.isEmpty()) {
      percent = OptionalInt.empty();
      say();
    }
    long in = 0;
    long hidden = 0;
    Map<ChainStage, FilterTiming> now = new HashMap<>(from);
    for (ChainStage stage : on) {
      now.put(stage, stage.timing());
      FilterTiming since = now.get(stage).since(from.getOrDefault(stage, FilterTiming.NONE));
      in = Math.max(in, since.eventsIn());
      hidden += since.eventsIn() - since.eventsOut();
    }
    if (in >= MIN_EVENTS) {
      percent = OptionalInt.of((int) Math.round(100.0 * Math.min(in, hidden) / in));
      from = now;
      say();
    }
  }

  private void say() {
    boolean any = percent.orElse(0) > 0;
    Controls.show(any, this);
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
