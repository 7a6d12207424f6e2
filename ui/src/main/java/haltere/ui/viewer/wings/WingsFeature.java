package haltere.ui.viewer.wings;

import atlantafx.base.theme.Styles;
import haltere.core.chain.FilterChain;
import haltere.core.format.AtomicFile;
import haltere.core.settings.Parameter;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTracker;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.wing.WingLogFormat;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.control.Button;

/**
 * Controls of the wing tracker: its filters live, the manual position of the fly, exchange of head
 * and tail, logs.
 */
public final class WingsFeature extends WindowFeature {
  private static final String MENU = "Wings";
  private static final long POLL_NANOS = 200_000_000;
  private static final List<WingLogFormat> FORMATS =
      List.of(
          new WingLogFormat(WingLogFormat.Rows.TICK, WingLogFormat.Layout.TABLE),
          new WingLogFormat(WingLogFormat.Rows.EVENT, WingLogFormat.Layout.TABLE),
          new WingLogFormat(WingLogFormat.Rows.BEAT, WingLogFormat.Layout.TABLE),
          new WingLogFormat(WingLogFormat.Rows.TICK, WingLogFormat.Layout.ORIGINAL),
          new WingLogFormat(WingLogFormat.Rows.EVENT, WingLogFormat.Layout.ORIGINAL));

  private final ObjectProperty<WingLogFormat> logFormat =
      new SimpleObjectProperty<>(FORMATS.get(0));
  private PlaybackOutput<WingLogOutput> log;
  private BooleanProperty shown;
  private BooleanProperty placing;
  private WingsPanel panel;
  private Optional<WingsView> seen = Optional.empty();
  private boolean isReading;

  @Override
  protected void install() {
    log = new PlaybackOutput<>(window);
    shown = window.addPanel("wings", PanelLayout.Position.SIDE, this::panel);
    window.panels().every(POLL_NANOS, this::pulse);
    window
        .sessions()
        .onChange(
            (was, is) -> {
              placing.set(false);
              seen = Optional.empty();
            });
    ViewerActions actions = window.actions();
    Supplier<String> obstacle = this::obstacle;
    placing = window.addTool("wings-place", new FlyTool(() -> seen, this::place), obstacle);
    actions.add("wings-flip", () -> settle(WingTracker::withHeadingFlipped), obstacle);
    actions.add("wings-search", () -> change((chain, view) -> view.filter().reset()), obstacle);
    actions.add("wings-log", log.runningProperty(), () -> log.toggle(this::askForLog), obstacle);
    actions.addChoices(
        "wings-log-", MENU + "/Rows of the log", logFormat, FORMATS, WingsFeature::label);
  }

  /** The reason why wing commands are unavailable; empty if they are available. */
  private String obstacle() {
    boolean hasTracker =
        window.sessions().session().stream()
            .flatMap(open -> open.chain().stages().stream())
            .anyMatch(stage -> stage.filter() instanceof WingTrackerFilter);
    return hasTracker ? "" : "no wing tracker in the chain";
  }

  private static String label(WingLogFormat format) {
    boolean original = format.layout() == WingLogFormat.Layout.ORIGINAL;
    return "Each " + Parameter.text(format.rows()) + (original ? ", layout of the original" : "");
  }

  private WingsPanel panel() {
    panel =
        new WingsPanel(
            List.of(
                button("flip", "The other end of the body is the head"),
                button("place", "Click the body, drag the head or the circle"),
                button("search", "Manual offsets of the fly remain"),
                button("log", "Starts or ends a log")),
            this);
    return panel;
  }

  /** A button of the panel that does a command of the menu. */
  private Button button(String command, String help) {
    Runnable work = () -> window.actions().run("wings-" + command);
    String text = ViewerActions.label("wings-" + command);
    return Controls.button("wings-panel-" + command, text, help, work, Styles.SMALL);
  }

  private void pulse() {
    if ((!shown.get() && !placing.get()) || isReading) {
      return;
    }
    isReading = true;
    window.read(
        WingsView::of,
        view -> {
          isReading = false;
          seen = view;
          if (panel != null) {
            panel.show(view);
          }
        });
  }

  private void settle(Function<WingTracker, WingTrackerSettings> change) {
    change(settling(change));
  }

  /** Sets the manual position of the fly in the tracker's settings. */
  private void place(Function<WingTracker, WingTrackerSettings> change) {
    window.editor().adjust(work(settling(change)), window.status()::showError);
  }

  private WingsChange settling(Function<WingTracker, WingTrackerSettings> change) {
    return (chain, view) ->
        window.editor().applyNow(chain, view.stage(), change.apply(view.filter().tracker()));
  }

  /** Switches the events of an edge on or off. */
  void takeEdge(WingPart edge, boolean on) {
    String setting =
        switch (edge) {
          case LEFT_LEADING -> "leftLeading";
          case LEFT_TRAILING -> "leftTrailing";
          case RIGHT_LEADING -> "rightLeading";
          default -> "rightTrailing";
        };
    settle(tracker -> tracker.settings().with("output." + setting + "=" + on));
  }

  /** Changes a number of a filter. */
  void edit(WingFilterEdit edit) {
    change((chain, view) -> view.filter().tracker().edit(edit));
  }

  void restart(WingPart part) {
    change((chain, view) -> view.filter().tracker().restart(part));
  }

  /** A change of a chain that has a wing tracker. */
  private interface WingsChange {
    void make(FilterChain chain, WingsView view);
  }

  private void change(WingsChange change) {
    window.editor().change(work(change), window.status()::showError);
  }

  private static Consumer<FilterChain> work(WingsChange change) {
    return chain -> change.make(chain, WingsView.orRefuse(chain));
  }

  private void askForLog() {
    window.dialogs().save("Log wings to", "wings.txt", "Logs", "*.txt").ifPresent(this::log);
  }

  /** Starts a log; replaces an existing file. */
  void log(Path file) {
    WingLogFormat format = logFormat.get();
    log(open -> WingLogOutput.begin(AtomicFile.create(file, true), format, open.player()));
  }

  void log(PlaybackOutput.Factory<WingLogOutput> factory) {
    log.start(factory);
  }

  /** The fly and its filters as they were seen last. */
  Optional<WingsView> seen() {
    return seen;
  }
}
