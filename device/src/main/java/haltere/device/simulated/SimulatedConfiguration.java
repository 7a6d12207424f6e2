package haltere.device.simulated;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.Configuration;
import haltere.core.camera.RegionOfInterest;
import haltere.core.settings.Parameter;
import java.util.List;
import java.util.Optional;

/** All settings of a simulated camera: its biases and its region. */
final class SimulatedConfiguration implements Configuration {
  private final CameraInfo info;
  private final RegionOfInterest region;
  private final Optional<SimulatedBiases> biases;

  SimulatedConfiguration(
      CameraInfo info, RegionOfInterest region, Optional<SimulatedBiases> biases) {
    this.info = info;
    this.region = region;
    this.biases = biases;
  }

  @Override
  public List<Parameter> parameters() {
    return List.of();
  }

  @Override
  public Object get(String name) {
    throw none(name);
  }

  @Override
  public void set(String name, Object value) {
    throw none(name);
  }

  private IllegalArgumentException none(String name) {
    return new IllegalArgumentException(
        info.id() + " has no setting named " + name + "; it has biases only");
  }

  @Override
  public String text() {
    StringBuilder text = new StringBuilder("camera = " + info.id() + "\n");
    region
        .region()
        .ifPresent(
            part ->
                text.append("region = ")
                    .append(part.width() + "x" + part.height())
                    .append(" at " + part.left() + "," + part.bottom())
                    .append(" px\n"));
    biases.ifPresent(all -> text.append(all.text()));
    return text.toString();
  }
}
