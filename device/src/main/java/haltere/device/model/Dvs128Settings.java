package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.Configuration;
import haltere.core.camera.Led;
import haltere.core.settings.Parameter;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** The settings of a DVS128 by name. */
final class Dvs128Settings implements Configuration {
  private static final String MASTER = "clock.master";
  private static final String HOLD = "pixels.hold";
  private static final String LED = "led.state";

  private final Dvs128Driver driver;
  private final Dvs128Biases biases;

  Dvs128Settings(Dvs128Driver driver, Dvs128Biases biases) {
    this.driver = driver;
    this.biases = biases;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(
        Settings.flag(MASTER, "Uses its own clock; off, the clock at its input.", true),
        Settings.flag(HOLD, "Holds all pixels in reset: no events.", false),
        Settings.choice(
            LED,
            "Mode of the LED.",
            Led.LedState.class,
            Led.LedState.ON,
            Arrays.stream(Led.LedState.values()).map(Enum::name).toList()));
  }

  @Override
  public Object get(String name) {
    Settings.named(parameters(), name);
    return switch (name) {
      case MASTER -> driver.wantsMaster();
      case HOLD -> driver.isHolding();
      default -> driver.led();
    };
  }

  @Override
  public void set(String name, Object value) throws CameraProblem {
    Object converted = Settings.named(parameters(), name).convert(value);
    switch (name) {
      case MASTER -> driver.setMaster((Boolean) converted);
      case HOLD -> driver.holdPixels((Boolean) converted);
      default -> driver.setLed((Led.LedState) converted);
    }
  }

  @Override
  public String text() {
    return Settings.text(
            "camera = " + driver.info().model() + " " + driver.info().serial(), this, biases)
        + String.format(Locale.ROOT, "firmware = %d%n", driver.firmware()).replace("\r", "");
  }
}
