package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.BiasSliders.Slider;
import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.MemoryBus;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class Dvs128BiasesTest {
  private final MemoryBus bus = new MemoryBus();
  private final Dvs128Firmware firmware = new Dvs128Firmware("0042");
  private Camera camera;
  private Biases biases;
  private BiasSliders sliders;

  @BeforeEach
  void open() throws CameraProblem {
    bus.plug(2, firmware);
    UsbCameraProvider provider = new UsbCameraProvider(bus);
    camera = provider.open(provider.list().get(0), CameraOptions.DEFAULT);
    biases = camera.facet(Biases.class).orElseThrow();
    sliders = camera.facet(BiasSliders.class).orElseThrow();
  }

  @AfterEach
  void close() {
    camera.close();
    bus.close();
  }

  private int sent(int index) {
    byte[] bytes = firmware.biases();
    return (bytes[3 * index] & 0xff) << 16
        | (bytes[3 * index + 1] & 0xff) << 8
        | bytes[3 * index + 2] & 0xff;
  }

  @Test
  void fastBiasSetIsTheDefault() {
    assertEquals(1992, sent(0));
    assertEquals(217, sent(11));
    assertEquals(209996, biases.get("diffOn"));
  }

  @Test
  void eachSliderScalesItsBiasesReversibly() throws CameraProblem {
    sliders.set(Slider.THRESHOLD, 0.5);
    assertEquals(2_099_960, biases.get("diffOn"));
    assertEquals(13, biases.get("diffOff"));
    assertEquals(2_099_960, sent(8));
    sliders.set(Slider.THRESHOLD, 0);
    assertEquals(209_996, biases.get("diffOn"));
    assertEquals(132, biases.get("diffOff"));

    sliders.set(Slider.BANDWIDTH, 0.5);
    assertEquals(Math.round(271 * Math.sqrt(300)), biases.get("foll"));
    sliders.set(Slider.REFRACTORY_PERIOD, 1);
    assertEquals(3, biases.get("refr"), "a smaller current is a longer rest");
    sliders.set(Slider.BALANCE, -1);
    assertEquals(131, biases.get("diff"));
  }

  @Test
  void slidersAreMonotoneStayInRangeAndKeepTheBiasSetAtZero() throws CameraProblem {
    for (String set : biases.sets()) {
      biases.apply(set);
      SliderChecks.check(biases, sliders);
    }
  }

  @Test
  void applyingABiasSetResetsTheSliders() throws CameraProblem {
    sliders.set(Slider.BANDWIDTH, 0.5);
    biases.apply("slow");

    assertEquals(0, sliders.get(Slider.BANDWIDTH));
    assertEquals(51, biases.get("foll"));
  }

  @Test
  void biasSetByNameTakesEffectAndResetsItsSlider() throws CameraProblem {
    sliders.set(Slider.BANDWIDTH, 0.5);
    biases.set("foll", 100);

    assertEquals(100, biases.get("foll"));
    assertEquals(0, sliders.get(Slider.BANDWIDTH));
  }

  @Test
  void invalidNamesAndValuesOutOfRangeAreRejected() {
    assertTrue(
        assertThrows(IllegalArgumentException.class, () -> biases.set("foo", 1))
            .getMessage()
            .startsWith("there is no bias foo; there are cas, injGnd"));
    assertThrows(IllegalArgumentException.class, () -> biases.set("Pr", 1 << 24));
    assertThrows(IllegalArgumentException.class, () -> biases.set("Pr", Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> sliders.set(Slider.BALANCE, 1.1));
    assertThrows(IllegalArgumentException.class, () -> biases.apply("quick"));
  }
}
