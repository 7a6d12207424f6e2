package haltere.ui.viewer.cameras;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProvider;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.Cameras;
import haltere.core.camera.RegionOfInterest;
import haltere.core.camera.RegionOfInterest.Region;
import haltere.core.camera.TimestampReset;
import haltere.core.playback.CameraPlayable;
import haltere.core.stream.internal.Daemon;
import haltere.device.simulated.Plug;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.RegionTool;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.stage.WindowEvent;
import javafx.util.Duration;

/** Cameras: lists and opens them; shows a panel of biases, region, counts and losses. */
public final class CameraFeature extends WindowFeature {
  private static final String MENU = "Camera";
  private static final String OPEN = MENU + "/Open";
  private static final String OPEN_SIMULATED = MENU + "/Open simulated";
  private static final String SIMULATED = "simulated:";
  private static final String ID = "open-camera-";
  private static final long NUMBERS_NANOS = 250_000_000;

  private final Cameras cameras = Cameras.installed();
  private BooleanProperty drawing;
  private CameraPanel panel;
  private Optional<CameraPlayable> open = Optional.empty();
  private boolean everListed;
  private boolean isUnpluggedShown;
  private Optional<CameraProvider.Watch> watch = Optional.empty();
  private boolean ended;

  /**
   * Delay after a connection: permissions may be set a moment later, and several cameras may be
   * connected at once.
   */
  private final PauseTransition comingSoon = new PauseTransition(Duration.seconds(1));

  @Override
  protected void install() {
    panel = new CameraPanel(window.background());
    comingSoon.setOnFinished(over -> list());
    BooleanProperty shown = window.addPanel("camera", PanelLayout.Position.SIDE, () -> panel);
    ViewerActions actions = window.actions();
    Supplier<String> obstacle = () -> open.isPresent() ? "" : "no camera is open";
    actions.add("list-cameras", this::list);
    actions.add("camera-reset-time", this::resetTime, obstacle);
    RegionTool tool = new RegionTool(() -> open.orElseThrow().geometry(), this::setRegion);
    drawing = window.addTool("camera-region", tool, obstacle);
    actions.add("camera-plug", this::togglePlug, obstacle);
    window.sessions().onChange((was, is) -> follow(is, shown));
    window.panels().every(NUMBERS_NANOS, () -> open.ifPresent(this::pulse));
    window.stage().addEventHandler(WindowEvent.WINDOW_HIDDEN, event -> end());
  }

  private void follow(Optional<ViewerSession> session, BooleanProperty shown) {
    boolean hadCamera = open.isPresent();
    open = session.flatMap(ViewerSession::camera);
    isUnpluggedShown = false;
    panel.setCamera(open.map(CameraPlayable::camera));
    window.status().setLive("", 0, false);
    drawing.set(drawing.get() && open.isPresent());
    if (hadCamera || open.isPresent()) {
      shown.set(open.isPresent());
    }
    if (!everListed && session.isPresent()) {
      list();
    }
  }

  // ---- List of cameras

  /** Lists the cameras in the background: USB takes some time. */
  void list() {
    boolean first = !everListed;
    everListed = true;
    runUsbTask(
        () -> {
          if (first) {
            CameraProvider.Watch started =
                cameras.watch(() -> Platform.runLater(comingSoon::playFromStart));
            Platform.runLater(() -> keep(started));
          }
          List<CameraInfo> seen = cameras.list();
          Platform.runLater(() -> show(seen));
        });
  }

  /** Runs a USB task, which may take a moment, beside the file tasks. */
  private static void runUsbTask(Runnable work) {
    Daemon.thread(work, "haltere-cameras").start();
  }

  /** Watches until the window is closed. */
  private void keep(CameraProvider.Watch started) {
    if (ended) {
      runUsbTask(started::close);
    } else {
      watch = Optional.of(started);
    }
  }

  private void end() {
    ended = true;
    watch.ifPresent(started -> runUsbTask(started::close));
    watch = Optional.empty();
  }

  private void show(List<CameraInfo> seen) {
    Map<String, ViewerAction> actions = new LinkedHashMap<>();
    for (CameraInfo info : seen) {
      String id = ID + info.id().replace(':', '-');
      Runnable choose = () -> choose(info);
      String menu = info.id().startsWith(SIMULATED) ? OPEN_SIMULATED : OPEN;
      actions.putIfAbsent(id, ViewerAction.of(id, label(info), menu, choose).withHelp(info.note()));
    }
    window.actions().offer(MENU, List.copyOf(actions.values()));
  }

  private static String label(CameraInfo info) {
    String obstacle = info.canOpen() ? "" : "   (cannot be opened)";
    return Texts.source(info.id()) + "   " + info.geometry() + obstacle;
  }

  private void choose(CameraInfo info) {
    if (info.canOpen()) {
      open(info.id());
    } else {
      window.status().showRefusal(info.id() + " cannot be opened: " + info.note());
    }
  }

  /** Opens a camera in place of the present source. */
  public void open(String id) {
    window.sessions().open(SessionRequest.made(() -> CameraPlayable.open(cameras, id), id));
  }

  // ---- Commands to a camera

  private <F> void applyToFacet(Class<F> facet, String ability, FacetAction<F> command) {
    Optional<F> there = open.map(CameraPlayable::camera).flatMap(camera -> camera.facet(facet));
    if (there.isEmpty()) {
      window.status().showRefusal("There is no camera open that " + ability);
      return;
    }
    window
        .background()
        .file(() -> command.apply(there.get()), panel::refresh, window.status()::showProblem);
  }

  private interface FacetAction<F> {
    void apply(F facet) throws Exception;
  }

  void resetTime() {
    applyToFacet(TimestampReset.class, "has a clock to be reset", TimestampReset::resetTimestamps);
  }

  void togglePlug() {
    applyToFacet(
        Plug.class,
        "is simulated",
        plug -> {
          if (plug.isPluggedIn()) {
            plug.unplug();
          } else {
            plug.plugIn();
          }
        });
  }

  void setRegion(Optional<PixelRegion> region) {
    Optional<Region> wanted =
        region.map(part -> new Region(part.left(), part.bottom(), part.width(), part.height()));
    applyToFacet(
        RegionOfInterest.class, "can send a part of its sensor", roi -> roi.setRegion(wanted));
  }

  // ---- State of the camera

  private void pulse(CameraPlayable shown) {
    CameraStatistics now = shown.camera().statistics();
    panel.update(now);
    boolean gone = shown.isUnplugged();
    window.status().setLive(gone ? "" : CameraPanel.line(now), now.lostEvents(), gone);
    if (gone && !isUnpluggedShown) {
      String id = shown.camera().info().id();
      window.status().showError(id + " was unplugged; it continues when it is plugged in again");
    } else if (!gone && isUnpluggedShown) {
      window.status().clearError();
    }
    isUnpluggedShown = gone;
  }

  /** The camera that is open. */
  Optional<CameraPlayable> camera() {
    return open;
  }
}
