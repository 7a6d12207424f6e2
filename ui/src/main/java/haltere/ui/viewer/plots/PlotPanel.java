package haltere.ui.viewer.plots;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.playback.PlayerStatus;
import haltere.core.stream.StreamNotification;
import haltere.ui.plot.InertialFeed;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.TimeWindow;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.playback.PlaybackController;
import java.util.ArrayList;
import java.util.List;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.geometry.Side;
import javafx.scene.control.Button;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ScrollPane;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Priority;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;

/** Plots of published results, stacked over one time axis. */
public final class PlotPanel extends BorderPane {
  private static final long FRAME_NANOS = 30_000_000;
  private static final long VALUES_NANOS = 100_000_000;
  private static final long FIRST_SPAN_US = 100_000;

  private final PlaybackController playback;
  private final TimeWindow window = new TimeWindow();
  private final PlotFeeds feeds;
  private final List<PlotLane> lanes = new ArrayList<>();
  private List<PlotField> first = List.of();
  private final VBox laneBox = new VBox();
  private final PlotTimeAxis axis = new PlotTimeAxis(window);
  private final MenuButton add = Controls.named(new MenuButton("Add plot"), "add-plot");
  private final ToggleButton follow =
      Controls.toggle("plot-follow", Icons.PLAY, "Follow the newest values");
  private final Label span = Controls.label("", "status-number");
  private final Label empty =
      Controls.paragraph(
          "Nothing is plotted. Add plot offers the event rate, what filters publish, and samples"
              + " of an inertial sensor.",
          "chain-empty");
  private final Label lost = Controls.label("", "problem");
  private final ObjectProperty<List<List<PlotField>>> plotted =
      new SimpleObjectProperty<>(List.of());
  private List<PlotField> offered = List.of();
  private boolean offersInertial;
  private PlotColours colours = PlotColours.DARK;
  private double pointed = Double.NaN;
  private long startUs;
  private long nowUs;
  private long drawnNanos;
  private long valuesNanos;
  private boolean dirty = true;

  /** A panel without lanes. Playback seeks to a time chosen in a plot. */
  public PlotPanel(ChainEditor editor, PlaybackController playback) {
    this.playback = playback;
    feeds = new PlotFeeds(editor, this::offer);
    Controls.named(this, "plots", "plots");
    Controls.help(add, "What filters publish, over time");
    follow.setSelected(true);
    follow.setOnAction(event -> setFollowing(follow.isSelected()));
    HBox head =
        Controls.row(
            6,
            add,
            follow,
            Controls.button("plot-less-time", Icons.LESS, "Show less time", () -> zoom(0.5, 1)),
            span,
            Controls.button("plot-more-time", Icons.ADD, "Show more time", () -> zoom(2, 1)),
            lost,
            Controls.growing(new Region()),
            Controls.button("plot-clear", Icons.RESET, "Clear the plots", this::clear));
    head.getStyleClass().addAll("plots-head");
    laneBox.setFillWidth(true);
    ScrollPane lanesView = Controls.scrolling(laneBox);
    lanesView.setFitToHeight(true);
    lanesView.setFocusTraversable(false);
    VBox.setVgrow(lanesView, Priority.ALWAYS);
    setTop(head);
    setCenter(new VBox(empty, lanesView, axis));
    setMinHeight(120);
    layoutBoundsProperty().subscribe(bounds -> dirty = true);
    offer(List.of());
    showSpan();
    editor.onChange(this::followChain);
    plotted.subscribe(
        wanted -> {
          if (!wanted.equals(fields())) {
            show(wanted);
          }
        });
  }

  /** Draws for a dark window, or for a light one. */
  public void setDark(boolean dark) {
    colours = dark ? PlotColours.DARK : PlotColours.LIGHT;
    dirty = true;
  }

  /** The fields of each lane, to be found again. */
  public List<Lane> lanes() {
    return lanes.stream().map(PlotLane::lane).toList();
  }

  /** Which part of the time is seen. */
  public TimeWindow window() {
    return window;
  }

  /** Subscribes to the present chain. */
  public void followChain() {
    feeds.follow(lanes());
  }

  /** Switches to another recording with its inertial samples: plotted samples are removed. */
  public void reset(InertialFeed newInertial) {
    feeds.setInertial(newInertial);
    offersInertial = false;
    clear();
    setFollowing(true);
    followChain();
  }

  /** The plotted samples as a table. */
  public String table() {
    return Lane.table(lanes(), window);
  }

  private void offer(List<PlotField> published) {
    offersInertial = feeds.hasInertial();
    List<PlotField> fields = new ArrayList<>(published);
    if (offersInertial) {
      fields.addAll(InertialFeed.FIELDS);
    }
    offered = fields;
    add.getItems().setAll(PlotMenu.sets(fields, set -> show(set.lanes())));
    add.getItems().addAll(PlotMenu.items(fields, this::addLane));
    lanes.forEach(lane -> lane.followPublished(fields));
  }

  /** Opens the menu of all that can be plotted. */
  public void showMenu() {
    add.show();
  }

  /** Adds a lane below the others. */
  public void addLane(PlotField field) {
    PlotLane lane = new PlotLane(new Lane(field), window);
    Button another =
        Controls.button("plot-add-here", Icons.ADD, "Plot something else in this lane", () -> {});
    another.setOnAction(
        event -> {
          ContextMenu menu = new ContextMenu();
          menu.getItems().setAll(PlotMenu.items(offered, chosen -> addTo(lane, chosen)));
          menu.show(another, Side.BOTTOM, 0, 0);
        });
    lane.addButtons(
        another,
        Controls.button("plot-remove", Icons.REMOVE, "Remove this plot", () -> remove(lane)));
    VBox.setVgrow(lane, Priority.ALWAYS);
    PlotGestures.on(lane.plot(), this);
    lanes.add(lane);
    laneBox.getChildren().add(lane);
    changed();
  }

  /** Shows the fields of each lane in place of all others. */
  private void show(List<List<PlotField>> wanted) {
    List.copyOf(lanes).forEach(this::remove);
    for (List<PlotField> fields : wanted) {
      addLane(fields.get(0));
      PlotLane lane = lanes.get(lanes.size() - 1);
      fields.subList(1, fields.size()).forEach(field -> addTo(lane, field));
    }
  }

  /**
   * Opens default plots of 0.1 s, in which single wing beats are visible; false if there is nothing
   * to show.
   */
  public boolean beginWith(List<PlotField> fields) {
    if (fields.isEmpty() || !lanes.isEmpty()) {
      return false;
    }
    fields.forEach(this::addLane);
    first = fields;
    zoom((double) FIRST_SPAN_US / window.spanUs(), 1);
    return true;
  }

  /** Removes unchanged default plots for which another chain publishes nothing; false otherwise. */
  public boolean dropFirst(FilterChain chain) {
    boolean isAsInitially =
        !first.isEmpty() && fields().stream().flatMap(List::stream).toList().equals(first);
    List<String> stages = chain.innermostStages().stream().map(ChainStage::name).toList();
    boolean published = first.stream().map(PlotField::stage).anyMatch(stages::contains);
    if (!isAsInitially || published) {
      return false;
    }
    List.copyOf(lanes).forEach(this::remove);
    first = List.of();
    return true;
  }

  private void addTo(PlotLane lane, PlotField field) {
    lane.add(field);
    changed();
  }

  private void remove(PlotLane lane) {
    lanes.remove(lane);
    laneBox.getChildren().remove(lane);
    changed();
  }

  /** The fields of each lane. */
  public ObjectProperty<List<List<PlotField>>> fieldsProperty() {
    return plotted;
  }

  private List<List<PlotField>> fields() {
    return lanes().stream().map(Lane::fields).toList();
  }

  private void changed() {
    plotted.set(fields());
    Controls.show(lanes.isEmpty(), empty);
    dirty = true;
    followChain();
  }

  private void clear() {
    lanes.forEach(lane -> lane.lane().clear());
    dirty = true;
  }

  /** Points at a share of the window, 0 to 1; NaN for none. */
  void point(double share) {
    pointed = share;
    valuesNanos = 0;
    dirty = true;
  }

  /** The share of the window under the pointer; NaN without one. */
  double pointed() {
    return pointed;
  }

  /** Shows so much later times. */
  void scroll(double share) {
    window.scroll(Math.round(share * window.spanUs()));
    setFollowing(false);
  }

  /** Seeks to a share of the window. */
  void goTo(double share) {
    playback.seek(Math.max(0, window.timeAt(share) - startUs));
  }

  /** Scales the window around a share of it. */
  void zoom(double factor, double share) {
    window.zoom(factor, share);
    showSpan();
    dirty = true;
  }

  private void showSpan() {
    span.setText(Texts.duration(window.spanUs()));
  }

  /** Follows the newest values, or not. */
  void setFollowing(boolean on) {
    window.setFollowing(on);
    follow.setSelected(on);
    dirty = true;
  }

  /** Fetches new samples and draws them at most some 30 times a second, not during run-ups. */
  public void update(PlayerStatus status, long nanos) {
    List<Lane> plotted = lanes();
    if (feeds.hasInertial() && !offersInertial) {
      followChain();
      offersInertial = true;
    }
    dirty |= feeds.drainTo(plotted);
    // a run-up has no displayed time
    if (nowUs != status.timeUs() && status.timeUs() != StreamNotification.NO_TIME_US) {
      if (status.timeUs() < nowUs) {
        // curves of tracks that do not recur would remain; samples of the
        // displayed slice may have arrived already
        plotted.forEach(lane -> lane.removeFrom(status.timeUs() + status.sliceUs()));
      }
      nowUs = status.timeUs();
      startUs = status.timeUs() - status.elapsedUs();
      dirty = true;
      for (Lane lane : plotted) {
        if (lane.has(PlotField.EVENT_RATE)) {
          lane.take(PlotField.EVENT_RATE, nowUs, "", status.eventRateEps());
        }
      }
    }
    window.advanceTo(nowUs);
    if (dirty && isVisible() && status.runUpUs() == 0 && nanos - drawnNanos >= FRAME_NANOS) {
      drawnNanos = nanos;
      // no later picture in a pause would show the newest values
      dirty = nanos - valuesNanos < VALUES_NANOS;
      draw(nanos);
    }
  }

  private void draw(long nanos) {
    lanes.forEach(lane -> lane.draw(colours, nowUs, startUs));
    axis.draw(colours, startUs);
    if (nanos - valuesNanos >= VALUES_NANOS) {
      valuesNanos = nanos;
      lanes.forEach(lane -> lane.showValues(pointed, colours));
      long gone = feeds.lost();
      lost.setText(gone == 0 ? "" : Texts.count(gone) + " values came too fast to be plotted");
    }
  }

  /** Listens to no chain any more. */
  public void close() {
    feeds.close();
  }
}
