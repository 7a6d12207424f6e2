package haltere.ui.viewer.cameras;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.RegionOfInterest;
import haltere.core.json.internal.Json;
import haltere.core.sink.LineAddress;
import haltere.device.simulated.Plug;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.saving.PublishFeature;
import haltere.ui.viewer.saving.SavingFeature;
import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import javafx.scene.control.MenuButton;
import javafx.scene.control.ToggleButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** A camera in the window, with the simulated fly in its place. */
@Timeout(120)
class CameraFeatureTest {
  @TempDir Path folder;

  private static CameraFeature openFly(ViewerHarness harness) {
    CameraFeature feature = harness.window.feature(CameraFeature.class);
    harness.run(() -> feature.open("simulated:fly"));
    harness.waitUntilOpen("simulated:fly");
    return feature;
  }

  private static Camera camera(CameraFeature feature) {
    return feature.camera().orElseThrow().camera();
  }

  @Test
  void menuListsAndOpensCameras() {
    try (ViewerHarness harness = ViewerHarness.withBlob()) {
      harness.waitFor(
          "the list of cameras",
          () -> harness.window.context().actions().find("open-camera-simulated-fly").isPresent());
      harness.run(() -> harness.window.context().actions().run("list-cameras"));
      harness.run(() -> harness.window.context().actions().run("open-camera-simulated-fly"));
      harness.waitUntilOpen("simulated:fly");
      harness.waitFor("the panel", () -> harness.isThere("camera-panel"));
      assertTrue(harness.text("camera-name").startsWith("Simulated fly"));
      harness.run(() -> harness.stage.setWidth(800));
      javafx.scene.control.Label name =
          harness.node("camera-name", javafx.scene.control.Label.class);
      harness.waitFor(
          "the whole name, in two lines if need be",
          () ->
              name.getWidth() >= name.prefWidth(-1)
                  || name.getHeight() > 1.5 * name.prefHeight(10_000));
      harness.waitFor("its numbers", () -> harness.text("camera-statistics").contains("transfers"));
      harness.waitFor("the bottom line", () -> harness.text("status-live").contains(" waiting, "));
    }
  }

  @Test
  void eventsThatAPausedCameraLosesAreCountedInTheBottomLine() {
    try (ViewerHarness harness = new ViewerHarness()) {
      openFly(harness);
      harness.pause();
      harness.waitFor(
          "lost events", () -> !harness.text("camera-statistics").contains("lost 0 events"));
      harness.waitFor("their count", () -> !harness.text("status-dropped").equals("0 lost"));
      assertEquals(0, harness.status().droppedEvents());
    }
  }

  @Test
  void unpluggedCameraHasNoRateAndNoSpeed() {
    try (ViewerHarness harness = new ViewerHarness()) {
      CameraFeature feature = openFly(harness);
      harness.waitFor("the speed", () -> harness.isThere("status-speed"));
      harness.waitFor("the rate", () -> harness.text("status-rate").endsWith("ev/s"));
      harness.run(feature::togglePlug);
      harness.waitFor("why", () -> harness.text("status-message").contains("was unplugged"));
      harness.waitFor(
          "no old numbers",
          () -> !harness.isThere("status-speed") && harness.text("status-rate").isEmpty());
      harness.run(feature::togglePlug);
      harness.waitFor("the speed again", () -> harness.isThere("status-speed"));
      harness.waitFor("the rate again", () -> harness.text("status-rate").endsWith("ev/s"));
    }
  }

  @Test
  void panelOfACameraIsClosedWithIt() {
    try (ViewerHarness harness = new ViewerHarness()) {
      openFly(harness);
      harness.waitFor("the panel", () -> harness.isThere("camera-panel"));
      harness.run(() -> harness.window.context().actions().run("open-scene"));
      harness.waitUntilOpen("Fly scene");
      harness.waitFor(
          "the chain alone",
          () -> !harness.isThere("camera-panel") && harness.isThere("stage-wing-tracker"));
    }
  }

  @Test
  void slidersBiasesAndSetsAreAppliedToTheCamera() {
    try (ViewerHarness harness = new ViewerHarness()) {
      CameraFeature feature = openFly(harness);
      Biases biases = camera(feature).facet(Biases.class).orElseThrow();
      javafx.scene.control.Slider threshold =
          harness.node("camera-slider-threshold", javafx.scene.control.Slider.class);
      harness.run(() -> threshold.setValue(1));
      harness.waitFor("the threshold", () -> Math.abs(biases.get("threshold") - 0.6) < 1e-9);
      harness.waitFor(
          "the field shows it",
          () ->
              harness
                  .node("entry-camera-threshold", javafx.scene.control.TextField.class)
                  .getText()
                  .startsWith("0.6"));
      @SuppressWarnings("unchecked")
      javafx.scene.control.ChoiceBox<String> sets =
          harness.node("camera-bias-sets", javafx.scene.control.ChoiceBox.class);
      harness.run(() -> sets.setValue("slow"));
      harness.waitFor("the set", () -> biases.get("bandwidthHz") == 300);
      harness.waitFor("the slider is in the middle", () -> threshold.getValue() == 0);
      javafx.scene.control.Slider bandwidth =
          harness.node("camera-slider-bandwidth", javafx.scene.control.Slider.class);
      harness.run(() -> bandwidth.setValue(1));
      harness.waitFor("the bandwidth", () -> biases.get("bandwidthHz") == 3000);
    }
  }

  @Test
  void regionAndClockResetAreSentToTheCamera() {
    try (ViewerHarness harness = new ViewerHarness()) {
      CameraFeature feature = openFly(harness);
      RegionOfInterest roi = camera(feature).facet(RegionOfInterest.class).orElseThrow();
      harness.run(() -> feature.setRegion(Optional.of(new PixelRegion(10, 20, 30, 40))));
      harness.waitFor("the region", () -> roi.region().isPresent());
      harness.waitFor(
          "its words",
          () -> harness.text("camera-region-words").equals("Region 30 \u00d7 40 at 10, 20"));
      harness.run(() -> feature.setRegion(Optional.empty()));
      harness.waitFor("the whole sensor", () -> roi.region().isEmpty());
      long before = harness.status().timeUs();
      harness.waitFor("time", () -> harness.status().timeUs() > before + 400_000);
      long resetNanos = System.nanoTime();
      harness.run(feature::resetTime);
      harness.waitFor(
          "time from 0",
          () -> harness.status().timeUs() < 200_000 + (System.nanoTime() - resetNanos) / 1000);
    }
  }

  @Test
  void unpluggedCameraIsReportedAndContinuesAfterReconnect() {
    try (ViewerHarness harness = new ViewerHarness()) {
      CameraFeature feature = openFly(harness);
      Plug plug = camera(feature).facet(Plug.class).orElseThrow();
      harness.run(feature::togglePlug);
      harness.waitFor("the line", () -> harness.text("status-message").contains("was unplugged"));
      assertFalse(plug.isPluggedIn());
      long events = harness.status().eventsIn();
      harness.run(feature::togglePlug);
      harness.waitFor("events", () -> harness.status().eventsIn() > events + 1000);
      harness.waitFor(
          "no line any more", () -> !harness.text("status-message").contains("was unplugged"));
    }
  }

  @Test
  void cameraRecordingHasBiasesInItsHeader() throws Exception {
    Path file = folder.resolve("fly.aedat4");
    try (ViewerHarness harness = new ViewerHarness()) {
      CameraFeature feature = openFly(harness);
      camera(feature).facet(Biases.class).orElseThrow().set("threshold", 0.3);
      harness.click("usual-objects");
      ToggleButton button = harness.node("usual-objects", ToggleButton.class);
      harness.waitFor("the filter", button::isSelected);
      SavingFeature saving = harness.window.feature(SavingFeature.class);
      harness.run(() -> saving.record(file));
      harness.waitFor("a file", () -> Files.exists(file) && Files.size(file) > 20_000);
      harness.run(saving::toggleRecording);
      harness.waitFor("its end", () -> harness.text("status-message").startsWith("Recorded "));
    }
    try (var reader = haltere.core.format.Recordings.open(file)) {
      Map<String, String> metadata = reader.metadata();
      assertEquals("0.3 ln", metadata.get("camera.bias.threshold"));
      assertTrue(metadata.get("chain").contains("object-tracker"), metadata.toString());
      assertTrue(metadata.containsKey("clockOffsetUs"));
    }
  }

  @Test
  void cameraHasNoSpeedAndOpensWithoutErrorAfterTheFlyScene() {
    try (ViewerHarness harness = new ViewerHarness()) {
      harness.run(() -> harness.window.context().actions().run("scene-rendered-fly"));
      harness.waitFor(
          "slow motion", () -> harness.window.context().playback().speedProperty().get() < 0.1);
      openFly(harness);
      harness.waitFor("no speed", () -> harness.node("speed", MenuButton.class).isDisabled());
      assertEquals(1.0, harness.window.context().playback().speedProperty().get());
      assertFalse(harness.isThere("dismiss"), () -> harness.text("status-message"));
    }
  }

  @Test
  void missingCameraIsReportedInTheBottomLine() {
    try (ViewerHarness harness = ViewerHarness.withBlob()) {
      CameraFeature feature = harness.window.feature(CameraFeature.class);
      harness.run(feature::resetTime);
      harness.waitFor(
          "the line",
          () ->
              harness
                  .text("status-message")
                  .equals("There is no camera open that has a clock to be reset"));
      harness.run(() -> feature.open("dvs128:none"));
      harness.waitFor(
          "the problem", () -> harness.text("status-message").contains("there is no camera"));
    }
  }

  @Test
  void resultsAreSentToOtherPrograms() throws Exception {
    try (ViewerHarness harness = new ViewerHarness()) {
      openFly(harness);
      harness.click("usual-wings");
      ToggleButton button = harness.node("usual-wings", ToggleButton.class);
      harness.waitFor("the filter", button::isSelected);
      PublishFeature feature = harness.window.feature(PublishFeature.class);
      harness.run(() -> feature.start("tcp://127.0.0.1:0"));
      harness.waitFor("an address", () -> harness.text("status-message").startsWith("Sending"));
      String address = harness.text("status-message").replace("Sending results at ", "");
      int port = LineAddress.parse(address).port();
      try (Socket socket = new Socket("127.0.0.1", port);
          BufferedReader reader =
              new BufferedReader(
                  new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII))) {
        socket.setSoTimeout(20_000);
        Map<?, ?> message = (Map<?, ?>) Json.parse(reader.readLine(), "a message");
        assertTrue(message.containsKey("number"), message.toString());
        harness.run(() -> harness.window.context().actions().run("publish"));
        while (reader.readLine() != null) {
          // to the end
        }
      }
      harness.run(() -> feature.start("nonsense"));
      harness.waitFor(
          "the problem", () -> harness.text("status-message").contains("is not an address"));
    }
  }
}
