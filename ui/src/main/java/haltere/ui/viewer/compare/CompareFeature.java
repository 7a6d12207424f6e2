package haltere.ui.viewer.compare;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.PublishedMeans;
import haltere.ui.viewer.chain.ChainAccess;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.ChainPanel;
import haltere.ui.viewer.chain.StageState;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.ViewBar;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.session.ViewerSession;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import javafx.beans.binding.Bindings;
import javafx.beans.property.BooleanProperty;
import javafx.beans.value.ObservableBooleanValue;
import javafx.geometry.Orientation;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/**
 * Two chains side by side on the same events. The second chain starts as a copy of the first, with
 * its own settings in a tab, its own picture, and its published numbers beside those of the first.
 */
public final class CompareFeature extends WindowFeature {
  private static final long NUMBERS_NANOS = 1_000_000_000;

  private record Running(Player player, SecondChain second) {}

  /** A chain as JSON and as text, and its recent means. */
  private record Numbers(String json, String filters, Map<PlotField, Double> means) {
    /** Processing thread. */
    static Numbers of(PublishedMeans published) {
      String filters =
          published.chain().stages().stream()
              .filter(ChainStage::isEnabled)
              .map(stage -> Texts.title(stage.name()))
              .collect(Collectors.joining(", "));
      return new Numbers(
          ChainFile.write(published.chain()),
          filters.isEmpty() ? "no filters" : filters,
          published.means());
    }
  }

  private final EventView view = Controls.named(new EventView(), "second-event-view");
  private final ComparisonTable table = new ComparisonTable();
  private final Label firstName = Controls.named(new Label(), "first-chain-name", "chain-name");
  private final Label secondName = Controls.named(new Label(), "second-chain-name", "chain-name");
  private ChainEditor editor;
  private ChainPanel chainPanel;
  private BooleanProperty shown;
  private BooleanProperty settingsShown;
  private Optional<Running> running = Optional.empty();
  private int starts;

  @Override
  protected void install() {
    editor = new ChainEditor(window.status()::showError, window.editor().history());
    chainPanel = new ChainPanel(editor);
    chainPanel.setId("second-chain-panel");
    view.setAccessibleText("Events after the second chain");
    SplitPane settings = new SplitPane(chainPanel, table);
    settings.setOrientation(Orientation.VERTICAL);
    Region bar = new Region();
    bar.getStyleClass().addAll("view-bar");
    // as tall as the first picture's bar, so that both pictures have the same height
    ViewBar viewBar = window.panels().viewBar();
    bar.minHeightProperty().bind(viewBar.heightProperty());
    VBox above = new VBox(bar, secondName);
    BorderPane named = new BorderPane(view, above, null, null, null);
    window.panels().addAbovePicture(firstName);
    PanelLayout layout = window.panels().panelLayout();
    settingsShown =
        layout.offer("second-chain", "Second chain", PanelLayout.Position.SIDE, () -> settings);
    shown = layout.offer("compare", "Compare", PanelLayout.Position.BESIDE, () -> named);
    ObservableBooleanValue seen = named.sceneProperty().isNotNull();
    Controls.bindVisible(seen, firstName);
    // both pictures have the width of the narrower panel, so that their scales agree
    EventView first = window.panels().view();
    view.maxWidthProperty().bind(((Region) first.getParent()).widthProperty());
    // banners are above the first picture only
    above.minHeightProperty().bind(first.getParent().getParent().layoutYProperty());
    first
        .maxWidthProperty()
        .bind(Bindings.when(seen).then(named.widthProperty()).otherwise(Double.MAX_VALUE));
    window.actions().add("compare", shown, () -> shown.get() ? "" : window.nothingOpen());
    ToggleButton button =
        viewBar.tool("tool-compare", Icons.COMPARE, "Compare with a second chain (Ctrl+D)", shown);
    Controls.unless(window.nothingOpen(), button);
    shown.subscribe(
        (was, is) -> {
          settingsShown.set(is);
          follow(window.sessions().session());
        });
    window
        .sessions()
        .onChange(
            (was, is) -> {
              Controls.unless(window.nothingOpen(), button);
              follow(is);
            });
    window.editor().onChange(() -> running.ifPresent(this::listen));
    editor.onChange(() -> running.ifPresent(this::listen));
    first.onFrame(frame -> frame.beside().ifPresent(view::show));
    window.panels().every(NUMBERS_NANOS, () -> running.ifPresent(this::showNumbers));
  }

  /** The second chain; empty while nothing is compared. */
  public Optional<FilterChain> secondChain() {
    return running.map(now -> now.second().chain());
  }

  /** Changes the second chain. */
  ChainEditor editor() {
    return editor;
  }

  private void follow(Optional<ViewerSession> session) {
    int start = ++starts;
    running.ifPresent(this::stop);
    running = Optional.empty();
    if (shown.get() && session.isPresent()) {
      window.read(ChainFile::write, json -> begin(start, session.get(), json));
    }
  }

  private void begin(int start, ViewerSession session, String json) {
    window.file(
        () ->
            new SecondChain(
                ChainFile.parse(json, "the chain", session.chain().geometry()),
                session.chain(),
                session.display()),
        made -> begin(start, session, made));
  }

  private void begin(int start, ViewerSession session, SecondChain made) {
    if (start != starts) {
      window.background().close(made::close);
      return;
    }
    Player player = session.player();
    running = Optional.of(new Running(player, made));
    view.setGeometry(made.chain().geometry(), window.display().options().colours());
    running.ifPresent(this::listen);
    List<StageState> stages = StageState.of(made.chain());
    player.addRawSink(made);
    editor.setPresets(window.editor().presets());
    editor.setAccess(ChainAccess.beside(player, made.chain()));
    chainPanel.reset(stages, window.steps());
    // both chains start before this moment by their memory
    window.playback().jump(0);
  }

  private void stop(Running ended) {
    editor.history().remove(editor);
    window
        .background()
        .close(
            () -> {
              // a closed player delivers nothing any more
              ended.player().removeSink(ended.second()).exceptionally(closed -> null).join();
              ended.second().close();
            });
  }

  private void show(Label label, String which, Numbers of) {
    label.setText(which + window.editor().presetName(of.json()).orElse(of.filters()));
    Controls.help(label, which + of.filters());
  }

  /** Subscribes to the numbers of both present chains. */
  private void listen(Running now) {
    window.editor().onProcessing(now.second()::restartNumbers);
  }

  private void showNumbers(Running now) {
    chainPanel.update();
    window.read(
        first -> now.second().numbers().stream().map(Numbers::of).toList(),
        both -> {
          show(firstName, "First chain: ", both.get(0));
          show(secondName, "Second chain: ", both.get(1));
          List<ComparisonTable.ComparisonLine> lines =
              ComparisonTable.lines(both.get(0).means(), both.get(1).means());
          if (!lines.isEmpty()) {
            table.show(lines);
          }
        });
  }
}
