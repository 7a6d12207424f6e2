package haltere.ui.viewer.feature;

import haltere.core.event.SensorGeometry;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.rendering.ColourMap;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.ChainPanel;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.playback.SeekBar;
import haltere.ui.viewer.playback.TransportBar;
import haltere.ui.viewer.plots.PlotPanel;
import haltere.ui.viewer.session.ViewerSession;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.MenuBar;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/**
 * The panels of the window and their layout; passes them the newest frame and the player's status
 * at each pulse.
 */
public final class ViewerPanels extends BorderPane {
  /** Update interval of texts and numbers during playback. */
  private static final long NUMBERS_NANOS = 125_000_000;

  private final PlaybackController playback;
  private final ChainEditor editor;
  private final StatusLine statusLine;
  private final EventView view = new EventView();
  private final StackPane picture = new StackPane(view);
  private final HBox pictureRow = new HBox(picture);
  private final VBox pictureColumn = new VBox(pictureRow);
  private final ViewBar viewBar;
  private final ChainPanel chainPanel;
  private final TransportBar transport;
  private final SeekBar seekBar;
  private final PlotPanel plots;
  private final PanelLayout layout;
  private final FrameMeter meter = new FrameMeter();
  private final List<Runnable> pulseListeners = new ArrayList<>();
  private PlayerStatus shownStatus;
  private long numbersNanos;

  /** Panels without anything to show, between the menu above and the status line below. */
  public ViewerPanels(
      MenuBar menu,
      PlaybackController playback,
      ChainEditor editor,
      StatusLine statusLine,
      DisplayControl display) {
    this.playback = playback;
    this.editor = editor;
    this.statusLine = statusLine;
    chainPanel = new ChainPanel(editor);
    transport = new TransportBar(playback);
    seekBar = new SeekBar(playback);
    plots = new PlotPanel(editor, playback);
    viewBar = new ViewBar(display);
    pictureColumn.getChildren().add(0, viewBar);
    HBox.setHgrow(picture, Priority.ALWAYS);
    picture.setMinSize(0, view.getMinHeight());
    VBox.setVgrow(pictureRow, Priority.ALWAYS);
    layout = new PanelLayout(pictureColumn, chainPanel);
    setCenter(new StackPane(layout));
    setTop(menu);
    setBottom(new VBox(seekBar, transport, statusLine));
    getStyleClass().add("viewer");
    view.setGeometry(new SensorGeometry(128, 128), DisplayOptions.DEFAULT.colours());
  }

  /** The panels around the picture. */
  public PanelLayout panelLayout() {
    return layout;
  }

  /** The picture of the events. */
  public EventView view() {
    return view;
  }

  /** Shows a page in place of all panels and the playback bars; empty shows the panels. */
  public void showPage(Optional<Node> page) {
    ((StackPane) getCenter()).getChildren().setAll(page.orElse(layout));
    Controls.show(page.isEmpty(), seekBar, transport);
  }

  /** Adds a node above the picture, below its bar. */
  public void addAbovePicture(Node node) {
    pictureColumn.getChildren().add(1, node);
  }

  /** Adds a node at the left of the picture. */
  public void addBesidePicture(Node node) {
    pictureRow.getChildren().add(0, node);
  }

  /** Adds a node over the picture, which still gets the mouse where it is not covered. */
  public void addOverPicture(Node node, Pos place) {
    StackPane.setAlignment(node, place);
    StackPane.setMargin(node, new Insets(10));
    picture.getChildren().add(node);
  }

  /** Above the events. */
  public ViewBar viewBar() {
    return viewBar;
  }

  /** The plots of published results. */
  public PlotPanel plots() {
    return plots;
  }

  /** The buttons of playback. */
  public TransportBar transport() {
    return transport;
  }

  /** The recording at a glance. */
  public SeekBar seekBar() {
    return seekBar;
  }

  /** Pictures shown so far. */
  public long framesShown() {
    return meter.total();
  }

  /**
   * Shows a session that has not started, in place of another one; the filters of its chain are
   * added in steps.
   */
  public void reset(ViewerSession made, ColourMap colours, Executor steps) {
    String name = Texts.source(made.player().playable().name());
    SensorGeometry geometry = made.player().playable().geometry();
    statusLine.setSource(name + "   " + geometry.width() + " \u00d7 " + geometry.height());
    view.setGeometry(geometry, colours);
    chainPanel.reset(made.firstStages(), steps);
    plots.reset(made.inertial());
    seekBar.clear();
    shownStatus = null;
  }

  /** The areas for F6: the shown panels, and the bars below them. */
  public List<Node> areas() {
    List<Node> areas = new ArrayList<>(layout.shown());
    areas.set(0, view);
    areas.add(seekBar);
    areas.add(transport);
    return areas;
  }

  /** Adds a listener to each pulse of JavaFX while a session is open. */
  public void onPulse(Runnable listener) {
    pulseListeners.add(listener);
  }

  /** Adds a listener to the first pulse of JavaFX after each interval, while a session is open. */
  public void every(long nanos, Runnable listener) {
    long[] lastNanos = {System.nanoTime() - nanos};
    onPulse(
        () -> {
          long now = System.nanoTime();
          if (now - lastNanos[0] >= nanos) {
            lastNanos[0] = now;
            listener.run();
          }
        });
  }

  /** Sets the theme, dark or light, of parts without a style sheet. */
  public void setDark(boolean dark) {
    seekBar.setDark(dark);
    plots.setDark(dark);
  }

  /** Brings all panels up to date with a session; called at each pulse of JavaFX. */
  public void pulse(ViewerSession open, long nowNanos) {
    open.display().renderer().setScreenMapping(view.screenMapping());
    if (view.show(open.display(), editor::onProcessing)) {
      meter.shown();
    }
    pulseListeners.forEach(Runnable::run);
    playback.pulse(System.nanoTime());
    PlayerStatus now = open.player().status();
    plots.update(now, nowNanos);
    if (now == shownStatus && nowNanos - numbersNanos < NUMBERS_NANOS) {
      return;
    }
    seekBar.update(now);
    boolean held = now.state() != State.PLAYING;
    if (held || nowNanos - numbersNanos >= NUMBERS_NANOS) {
      numbersNanos = nowNanos;
      transport.update(now);
      statusLine.update(
          now,
          playback.reverseProperty().get(),
          meter.perSecond(nowNanos),
          open.display().renderer().exchange().conflated());
      chainPanel.update();
    }
    shownStatus = now;
  }
}
