package haltere.ui.viewer.space;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Cameras;
import haltere.core.format.ReadOptions;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerStatus;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.filters.orientation.camera.CameraModel;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.CameraRig;
import haltere.ui.space.LiveFlight;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.session.SessionRequest;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import javafx.scene.Node;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.image.WritableImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LiveFlightTest {
  @TempDir Path folder;

  private static final FlightSettings SETTINGS =
      FlightSettings.defaults().with("run.durationS=0.8", "view.cameras=2", "run.seed=11");

  /** Plays a rig through as a player does. */
  private static BodyFlight play(CameraRig rig, LiveFlight live) throws IOException {
    while (rig.first().next(live)) {
      // until the end
    }
    live.sliceEnd(0, 1);
    return live.latest();
  }

  @Test
  void axisOfASimulatedBodyIsEstimatedFromTwoEventCameras() throws IOException {
    try (CameraRig rig = CameraRig.simulated(SETTINGS)) {
      LiveFlight live = new LiveFlight(rig, List.of());
      BodyFlight flight = play(rig, live);
      assertNear(flight);
      rig.first().seek(0);
      assertEquals(flight, play(rig, live), "from the start again");
    }
  }

  @Test
  void goingBackDoesNotSimulateTheOtherCamerasAgain() throws IOException {
    try (CameraRig rig = CameraRig.simulated(SETTINGS)) {
      LiveFlight live = new LiveFlight(rig, List.of());
      BufferedPlayable first = new BufferedPlayable(rig.first(), 1_000_000);
      while (first.next(live)) {
        // until the end
      }
      BufferedPlayable other = (BufferedPlayable) rig.others().get(0);
      long seenUs = other.bufferedToUs();
      first.seek(300_000);
      while (first.next(live)) {
        assertEquals(seenUs, other.bufferedToUs());
      }
      live.sliceEnd(0, 1);
      List<BodyFlight.Moment> again = live.latest().moments();
      assertEquals(2, again.get(again.size() - 1).lines().size());
    }
  }

  private static void assertNear(BodyFlight flight) {
    FlightScene scene = new FlightScene(SETTINGS);
    assertEquals(2, flight.cameras().size());
    List<Double> errorsDeg = new ArrayList<>();
    for (BodyFlight.Moment moment : flight.moments()) {
      FlightTruth truth = scene.truthAt(moment.estimate().timeUs());
      double along =
          moment.estimate().ux() * truth.ux()
              + moment.estimate().uy() * truth.uy()
              + moment.estimate().uz() * truth.uz();
      errorsDeg.add(Math.toDegrees(Math.acos(Math.min(1, along))));
      assertEquals(2, moment.lines().size());
    }
    assertTrue(errorsDeg.size() > 30, errorsDeg.size() + " moments");
    Collections.sort(errorsDeg);
    double median = errorsDeg.get(errorsDeg.size() / 2);
    assertTrue(median < 8, "median " + median);
  }

  private static List<CameraModel> calibrated() throws IOException {
    try (CameraRig rig = CameraRig.simulated(SETTINGS)) {
      return rig.cameras();
    }
  }

  /** A recording of each camera. */
  private static List<Path> record(Path folder) throws IOException {
    List<Path> files = new ArrayList<>();
    try (CameraRig rig = CameraRig.simulated(SETTINGS)) {
      List<Playable> sources = new ArrayList<>(rig.others());
      sources.add(0, rig.first());
      for (Playable source : sources) {
        Path file = folder.resolve("camera-" + files.size() + ".aedat4");
        ViewerHarness.writeRecording(file, source);
        files.add(file);
      }
    }
    return files;
  }

  @Test
  void recordingsOfSeveralCamerasPlaySynchronously() throws IOException {
    List<Path> files = record(folder);
    List<CameraModel> cameras = calibrated();
    try (CameraRig rig =
        CameraRig.open(
            cameras, number -> SessionRequest.play(files.get(number), ReadOptions.DEFAULT))) {
      LiveFlight live = new LiveFlight(rig, List.of());
      assertNear(play(rig, live));
      rig.first().seek(100_000);
      BodyFlight again = play(rig, live);
      assertNear(again);
      long earliestUs = again.moments().get(0).estimate().timeUs();
      assertTrue(earliestUs > 100_000 && earliestUs < 500_000, "from " + earliestUs + " us on");
      rig.first().close();
    }
    try (ViewerHarness viewer = new ViewerHarness()) {
      LiveFlightFeature feature = viewer.window.feature(LiveFlightFeature.class);
      viewer.run(() -> feature.openRecordings(cameras, files));
      waitForAnAxis(viewer);
      assertEquals("camera-0.aedat4", viewer.session().player().playable().name());
    }
  }

  @Test
  void simultaneousCamerasAreMappedToOneClock() throws IOException {
    Cameras cameras = new Cameras(List.of(new FlightCameras(SETTINGS)));
    try (CameraRig rig = CameraRig.live(calibrated(), cameras)) {
      assertNear(play(rig, new LiveFlight(rig, List.of())));
    }
    try (ViewerHarness viewer = new ViewerHarness()) {
      LiveFlightFeature feature = viewer.window.feature(LiveFlightFeature.class);
      FlightSettings endless = SETTINGS.with("run.durationS=0");
      List<CameraModel> calibrated = calibrated();
      viewer.run(
          () -> feature.openCameras(calibrated, new Cameras(List.of(new FlightCameras(endless)))));
      waitForAnAxis(viewer);
      assertTrue(viewer.session().camera().isPresent());
    }
  }

  @Test
  void incompatibleCamerasAreReportedWithTheReason() throws IOException {
    List<CameraModel> cameras = calibrated();
    assertRefused(cameras.subList(0, 1), "needs two cameras");
    CameraModel first = cameras.get(0);
    CameraModel small = CameraModel.of(first.id(), first.matrix(), new double[0], 128, 128);
    assertRefused(List.of(cameras.get(1), small), "calibrated for 128");
    CameraModel unknown = CameraModel.of("left", first.matrix(), new double[0], 0, 0);
    assertRefused(List.of(first, unknown), "no camera left; there are camera-0");
  }

  private static void assertRefused(List<CameraModel> calibrated, String text) {
    Cameras cameras = new Cameras(List.of(new FlightCameras(SETTINGS)));
    IOException why =
        assertThrows(IOException.class, () -> CameraRig.live(calibrated, cameras).close());
    assertTrue(why.getMessage().contains(text), why.getMessage());
  }

  private static void waitForAnAxis(ViewerHarness viewer) {
    viewer.waitFor(
        "an orientation",
        () ->
            viewer.stage.getScene().lookup("#live-flight-words") instanceof Label text
                && text.getText().contains("axis"));
  }

  /** Pauses at a time with an observation of each of three cameras; plays on where one has none. */
  private static void openPausedWhereEachCameraSeesTheBody(ViewerHarness viewer) {
    viewer.run(viewer.window.feature(LiveFlightFeature.class)::openScene);
    Pattern allThree = Pattern.compile("used (3, rejected 0|2, rejected 1)");
    Supplier<String> text =
        () -> viewer.onFx(() -> viewer.node("live-flight-words", Label.class).getText());
    waitForAnAxis(viewer);
    do {
      viewer.run(() -> viewer.session().player().play());
      viewer.waitFor("a line of each camera", () -> allThree.matcher(text.get()).find());
      viewer.run(() -> viewer.session().player().pause());
      viewer.waitFor("a pause", () -> viewer.status().state() == PlayerStatus.State.PAUSED);
    } while (!allThree.matcher(text.get()).find());
  }

  /** The last events before a pause are drawn at one of the next pulses. */
  private static void waitUntilStill(ViewerHarness viewer, String id) {
    int[] still = {0};
    viewer.waitFor(
        "a still picture",
        () -> {
          still[0] = changedBy(viewer, id, () -> {}) == 0 ? still[0] + 1 : 0;
          return still[0] == 10;
        });
  }

  /** Pixels in which what a node shows changes by a switch. */
  private static int changedBy(ViewerHarness viewer, String id, Runnable change) {
    Node node = viewer.node(id, Node.class);
    WritableImage before = viewer.onFx(() -> node.snapshot(null, null));
    viewer.run(change);
    WritableImage after = viewer.onFx(() -> node.snapshot(null, null));
    int changed = 0;
    for (int y = 0; y < (int) before.getHeight(); y++) {
      for (int x = 0; x < (int) before.getWidth(); x++) {
        changed +=
            before.getPixelReader().getArgb(x, y) == after.getPixelReader().getArgb(x, y) ? 0 : 1;
      }
    }
    return changed;
  }

  @Test
  void linesAreDrawnOverEachCameraPictureWhileEnabled() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      openPausedWhereEachCameraSeesTheBody(viewer);
      CheckBox box = viewer.node("camera-lines", CheckBox.class);
      assertTrue(box.isSelected(), "at first");
      for (String picture : new String[] {"event-view", "camera-picture-1", "camera-picture-2"}) {
        viewer.waitFor("a picture", () -> viewer.stage.getScene().lookup("#" + picture) != null);
        waitUntilStill(viewer, picture);
        assertTrue(changedBy(viewer, picture, () -> box.setSelected(false)) > 20, picture);
        assertEquals(0, changedBy(viewer, picture, () -> {}), picture);
        assertTrue(changedBy(viewer, picture, () -> box.setSelected(true)) > 20, picture);
      }
    }
  }

  @Test
  void linesOverTheFirstPictureAreOfTheMomentOfAStep() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      openPausedWhereEachCameraSeesTheBody(viewer);
      for (int step = 0; step < 4; step++) {
        long before = viewer.status().elapsedUs();
        viewer.run(() -> viewer.session().player().step(-1));
        viewer.waitFor("a step", () -> viewer.status().elapsedUs() < before);
        waitUntilStill(viewer, "event-view");
        Runnable again = viewer.window.context().panels().view()::redraw;
        assertEquals(0, changedBy(viewer, "event-view", again), "step " + step);
      }
    }
  }

  @Test
  void windowShowsTheFlightDuringPlayback() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      LiveFlightFeature feature = viewer.window.feature(LiveFlightFeature.class);
      viewer.run(feature::openScene);
      waitForAnAxis(viewer);
      String text = viewer.onFx(() -> viewer.node("live-flight-words", Label.class).getText());
      viewer.waitFor(
          "another one",
          () -> !viewer.node("live-flight-words", Label.class).getText().equals(text));
      viewer.run(() -> viewer.window.context().actions().run("open-scene"));
      viewer.waitUntilOpen("Fly scene");
      viewer.waitFor("no panel of a flight", () -> !viewer.isThere("live-flight"));
    }
  }
}
