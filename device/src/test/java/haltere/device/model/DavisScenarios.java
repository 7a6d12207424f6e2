package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.BiasSliders.Slider;
import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.Configuration;
import haltere.core.camera.EarlyTransfer;
import haltere.core.camera.RegionOfInterest;
import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.Trigger;
import haltere.testing.usb.DavisFirmware;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Scenarios of a DAVIS on any bus. */
abstract class DavisScenarios extends DeviceBench<DavisFirmware> {
  private static final CameraOptions OPTIONS =
      new CameraOptions(4, 512, 64, WhenFull.DROP_NEWEST, true, false);

  DavisScenarios(BusUnderTest on) {
    super(on);
  }

  @Override
  DavisFirmware newFirmware() {
    return new DavisFirmware("00000123");
  }

  private Camera open() throws CameraProblem {
    return open(OPTIONS);
  }

  @Test
  void davisIsListedAndReportsItsChipOnceOpened() throws IOException {
    assertEquals("davis:00000123", provider.list().get(0).id());
    try (Camera camera = open()) {
      assertEquals("DAVIS346B", camera.info().model());
      assertEquals("346x260", camera.geometry().toString());
    }
  }

  @Test
  void startupEnablesChipBeforePixelsAndShutdownReversesTheOrder() throws IOException {
    Camera camera = open();
    started(camera);

    List<String> log = firmware.log();
    List<String> order = List.of("0.3=1", "9.0=1", "0.1=1", "0.0=1", "0.2=1", "1.3=1");
    for (int i = 1; i < order.size(); i++) {
      assertTrue(log.lastIndexOf(order.get(i - 1)) < log.lastIndexOf(order.get(i)), log.toString());
    }
    assertTrue(firmware.isStreaming());
    int before = log.size();
    camera.close();
    List<String> off = log.subList(before, log.size());
    assertTrue(off.indexOf("1.3=0") < off.indexOf("0.0=0"), off.toString());
    assertTrue(off.indexOf("0.0=0") < off.indexOf("0.3=0"), off.toString());
    assertFalse(firmware.isStreaming());
  }

  @Test
  void unsupportedLogicVersionIsRejectedWithTheRequiredVersion() {
    firmware.preset(6, 0, 15);

    CameraProblem problem = assertThrows(CameraProblem.class, this::open);

    assertEquals(CameraProblem.Kind.UNSUPPORTED, problem.kind());
    assertTrue(
        problem.getMessage().startsWith("this DAVIS has logic version 15, and 18 is needed"));
  }

  @Test
  void eventRowsAreFlippedAndTimestampsContinueAcrossWraps() throws IOException {
    try (Camera camera = open()) {
      StreamLog log = started(camera);
      firmware.event(7, 3, 0, true);
      firmware.event(40_000, 345, 259, false);
      firmware.event(1_000_000, 10, 100, true);
      firmware.endPacket();
      log.untilEvents(3);

      assertEquals(259, log.all.y(0));
      assertTrue(log.all.isOn(0));
      assertEquals(345, log.all.x(1));
      assertEquals(0, log.all.y(1));
      assertEquals(40_000, log.all.timeUs(1));
      assertEquals(1_000_000, log.all.timeUs(2));
      assertEquals(1, log.items.size(), "the reset at the start is no news");
    }
  }

  @Test
  void framesInertialSamplesAndTriggersAreDecodedAsSamples() throws IOException {
    try (Camera camera = open()) {
      StreamLog log = started(camera);
      firmware.special(5, 3);
      firmware.inertial(1000, 1, 2, 8192, -8192, 0, 340, 3277, 0, -3277);
      firmware.frame(2000, 10, 20, new int[][] {{800, 700, 600}, {500, 0, 950}});
      firmware.event(3000, 1, 1, true);
      firmware.endPacket();
      log.untilEvents(1);

      assertEquals(
          new Trigger(5, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0), log.items.get(1));
      InertialSample sample = (InertialSample) log.items.get(2);
      assertEquals(1000, sample.timeUs());
      assertEquals(1, sample.accelerationXG(), 1e-6);
      assertEquals(-1, sample.accelerationYG(), 1e-6);
      assertEquals(36, sample.temperatureC(), 1e-6);
      assertEquals(100, sample.rotationXDegS(), 0.02);
      Frame frame = (Frame) log.items.get(3);
      assertEquals(new Frame.Times(2010, 2110, 2010, 2200), frame.times());
      assertEquals("2x3", frame.width() + "x" + frame.height());
      assertEquals(10, frame.left());
      assertEquals(260 - 23, frame.bottom());
      assertEquals(100 << 6, frame.value(0, 2, 0));
      assertEquals(300 << 6, frame.value(0, 0, 0));
      assertEquals(1023 << 6, frame.value(1, 1, 0), "a signal of 0 is white");
      assertEquals(0, frame.value(1, 0, 0));
    }
  }

  @Test
  void incompleteFramesAndSamplesAreDiscarded() throws IOException {
    try (Camera camera = open()) {
      StreamLog log = started(camera);
      firmware.special(5, 8);
      firmware.special(6, 11);
      firmware.word(0x4000);
      firmware.special(7, 13);
      firmware.special(8, 10);
      firmware.special(9, 5);
      firmware.word(0x5001);
      firmware.special(10, 7);
      firmware.event(11, 400, 1, true);
      firmware.event(12, 1, 1, true);
      firmware.endPacket();
      log.untilEvents(1);

      assertEquals(12, log.all.timeUs(0));
      assertEquals(1, log.items.size(), log.items.toString());
      assertEquals(1, camera.statistics().unknownWords());
    }
  }

  @Test
  void lossPreservesTimeAndRowOfLaterEvents() throws IOException {
    try (Camera camera = open(OPTIONS.withBuffers(2, 512, 2))) {
      StreamLog log = started(camera);
      int count = 20_000;
      for (int i = 0; i < count; i++) {
        firmware.event(i * 10L, i % 346, i % 260, true);
      }
      firmware.endPacket();
      CameraBench.await(
          () ->
              firmware.eventsSent() == count
                  && camera.statistics().bytes() == firmware.bytesSent());
      log.drain();
      firmware.word(0x3000 | 7); // the row and the time of before
      firmware.endPacket();
      log.until(() -> log.events + log.lost == count + 1);

      int last = (int) log.events - 1;
      assertTrue(log.lost > 1000, log.toString());
      assertEquals((count - 1) * 10L, log.all.timeUs(last));
      assertEquals(259 - (count - 1) % 260, log.all.y(last));
      assertEquals(7, log.all.x(last));
    }
  }

  @Test
  void biasesAreEncodedAsCurrentsAndVoltages() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      assertEquals(4 << 12 | 39 << 4 | 0xf, firmware.register(5, 10), "DiffBn as usual");
      assertEquals(2 << 12 | 58 << 4 | 0xd, firmware.register(5, 14), "PrBp is of P type");
      assertEquals(6 << 6 | 27, firmware.register(5, 0), "a voltage");
      assertEquals(33 << 10 | 1 << 4, firmware.register(5, 35), "a shifted source");
      assertEquals(48_437.0 * 39 / 255, biases.get("DiffBn"), 1e-9);

      biases.set("DiffBn", 1000);

      assertEquals(3 << 12 | 42 << 4 | 0xf, firmware.register(5, 10));
      assertEquals(6054.0 * 42 / 255, biases.get("DiffBn"), 1e-9);
      assertThrows(IllegalArgumentException.class, () -> biases.set("DiffBn", 1e9));
    }
  }

  @Test
  void slidersScaleBiasesByRatios() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      BiasSliders sliders = camera.facet(BiasSliders.class).orElseThrow();
      double usual = biases.get("PrBp");

      sliders.set(Slider.BANDWIDTH, 1);

      assertEquals(usual * 30, biases.get("PrBp"), usual * 0.1);
      assertEquals(biases.get("PrBp"), currentPa(firmware.register(5, 14)), 1);
      biases.set("DiffBn", 1000);
      assertEquals(usual * 30, biases.get("PrBp"), usual * 0.1, "it stays as it was");
      assertEquals(0, sliders.get(Slider.BANDWIDTH), "which is the middle now");
      biases.apply("default");
      assertEquals(usual, biases.get("PrBp"));
      SliderChecks.check(biases, sliders);
    }
  }

  @Test
  void biasesStayAsTheyWereWhenTheCameraRefusesASet() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      BiasSliders sliders = camera.facet(BiasSliders.class).orElseThrow();
      sliders.set(Slider.THRESHOLD, 0.5);
      biases.set("DiffBn", 1000);
      sliders.set(Slider.THRESHOLD, 0.25);
      int register = firmware.register(5, 10);
      double diff = biases.get("DiffBn");
      double on = biases.get("OnBn");
      firmware.refuse(5, 12);

      assertThrows(CameraProblem.class, () -> biases.apply("default"));

      assertEquals(register, firmware.register(5, 10), "what was sent is taken back");
      assertEquals(diff, biases.get("DiffBn"));
      assertEquals(on, biases.get("OnBn"));
      assertEquals(0.25, sliders.get(Slider.THRESHOLD));
    }
  }

  @Test
  void sliderAndBiasesAreRestoredWhenTheCameraRefusesAChange() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      BiasSliders sliders = camera.facet(BiasSliders.class).orElseThrow();
      int before = firmware.register(5, 11);
      firmware.refuse(5, 12);

      CameraProblem problem =
          assertThrows(CameraProblem.class, () -> sliders.set(Slider.THRESHOLD, 0.5));

      assertEquals(CameraProblem.Kind.REFUSED, problem.kind());
      assertTrue(
          firmware.log().indexOf("5.11=" + before) < firmware.log().lastIndexOf("5.11=" + before));
      assertEquals(before, firmware.register(5, 11), "what was sent is taken back");
      assertEquals(0, sliders.get(Slider.THRESHOLD));
      assertEquals(387_500, biases.get("OnBn"), 1e-6);
    }
  }

  /** The current of a coarse and a fine part, by the full scales of the chip's makers. */
  private static double currentPa(int bits) {
    double[] fullPa = {11, 94, 756, 6054, 48_437, 387_500, 3_100_000, 24_800_000};
    return fullPa[bits >> 12] * (bits >> 4 & 0xff) / 255;
  }

  @Test
  void settingsWithUnitsAreWrittenToTheLogic() throws IOException {
    try (Camera camera = open()) {
      Configuration configuration = camera.facet(Configuration.class).orElseThrow();
      assertEquals(4000 * 30, firmware.register(2, 12));
      configuration.set("frames.exposureUs", 1500);
      assertEquals(1500 * 30, firmware.register(2, 12));
      configuration.set("frames.run", false);
      started(camera);
      assertEquals(0, firmware.register(2, 4));
      configuration.set("frames.run", "true");
      assertEquals(1, firmware.register(2, 4));
      assertTrue(configuration.text().contains("frames.exposureUs = 1500 us\n"));
      assertThrows(IllegalArgumentException.class, () -> configuration.set("frames.speed", 1));

      camera.facet(EarlyTransfer.class).orElseThrow().setMaxDelayUs(260);
      assertEquals(2 * 125 * 80, firmware.register(9, 1));
    }
  }

  @Test
  void regionOfInterestIsFlippedVerticallyForTheChip() throws IOException {
    try (Camera camera = open()) {
      RegionOfInterest region = camera.facet(RegionOfInterest.class).orElseThrow();
      region.setRegion(Optional.of(new RegionOfInterest.Region(10, 0, 20, 60)));

      assertEquals(10, firmware.register(1, 41));
      assertEquals(200, firmware.register(1, 42));
      assertEquals(29, firmware.register(1, 43));
      assertEquals(259, firmware.register(1, 44));
      region.setRegion(Optional.empty());
      assertEquals(0, firmware.register(1, 42));
      assertThrows(
          IllegalArgumentException.class,
          () -> region.setRegion(Optional.of(new RegionOfInterest.Region(340, 0, 20, 60))));
    }
  }

  @Test
  void davis240HasItsOwnSizeBiasesAndDoubledFrameValues() throws IOException {
    firmware.preset(6, 1, 2);
    firmware.preset(1, 0, 240);
    firmware.preset(1, 1, 180);
    try (Camera camera = open()) {
      assertEquals("DAVIS240C", camera.info().model());
      assertEquals("240x180", camera.geometry().toString());
      assertEquals(2 << 12 | 58 << 4 | 0xd, firmware.register(5, 8), "PrBp is of P type");
      assertEquals(33 << 10 | 1 << 4, firmware.register(5, 20), "a shifted source");
      StreamLog log = started(camera);
      firmware.frame(2000, 10, 20, new int[][] {{400, 300}});
      firmware.event(3000, 239, 179, true);
      firmware.endPacket();
      log.untilEvents(1);

      assertEquals(239, log.all.x(0));
      assertEquals(0, log.all.y(0));
      Frame frame = (Frame) log.items.get(1);
      assertEquals(1023 - 800 << 6, frame.value(0, 1, 0), "twice 400 is missing from the whole");
    }
  }

  @Test
  void reconnectedDavisReceivesAllSettingsAgain() throws IOException {
    try (Camera camera = open(OPTIONS.withReconnect(true))) {
      camera.facet(Biases.class).orElseThrow().set("DiffBn", 1000);
      camera.facet(Configuration.class).orElseThrow().set("frames.exposureUs", 1500);
      camera
          .facet(RegionOfInterest.class)
          .orElseThrow()
          .setRegion(Optional.of(new RegionOfInterest.Region(10, 0, 20, 60)));
      StreamLog log = started(camera);
      firmware.event(7, 3, 0, true);
      firmware.endPacket();
      log.untilEvents(1);
      device.unplug();
      log.until(() -> log.ends() == 1);

      DavisFirmware again = newFirmware();
      plug(again);
      log.until(() -> camera.statistics().streams() == 2);

      assertEquals(3 << 12 | 42 << 4 | 0xf, again.register(5, 10));
      assertEquals(1500 * 30, again.register(2, 12));
      assertEquals(29, again.register(1, 43));
      again.event(9, 3, 0, true);
      again.endPacket();
      log.untilEvents(2);
      assertEquals(9, log.all.timeUs(1));
    }
  }
}
