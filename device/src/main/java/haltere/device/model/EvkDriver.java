package haltere.device.model;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.Configuration;
import haltere.core.settings.Parameter;
import haltere.device.protocol.Evt3WireDecoder;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.UsbTransport;
import java.util.List;
import java.util.Map;

/**
 * An EVK4, experimental: it is identified and started, and its data are decoded as EVT3. The
 * hundreds of registers that initialise its sensor are not written here; the manufacturer's program
 * must be run once before.
 */
final class EvkDriver implements CameraDriver, Configuration {
  private static final DataEndpoint ENDPOINT = new DataEndpoint(0x81, 20, 128 << 10);

  private final CameraInfo info;
  private final ControlLine line = new ControlLine();

  EvkDriver(CameraInfo info) {
    this.info = info;
  }

  @Override
  public CameraInfo info() {
    return info;
  }

  @Override
  public DataEndpoint endpoint() {
    return ENDPOINT;
  }

  @Override
  public WireDecoder newDecoder(boolean samples) {
    return new Evt3WireDecoder(info.geometry(), samples);
  }

  @Override
  public void connect(UsbTransport transport) {
    line.connect(transport);
  }

  @Override
  public void start(Runnable startTransfers) throws CameraProblem {
    startTransfers.run();
    new TreuzellLine(line.transport()).stream(true);
  }

  @Override
  public void stop() throws CameraProblem {
    new TreuzellLine(line.transport()).stream(false);
  }

  @Override
  public void disconnect() {
    line.disconnect();
  }

  @Override
  public Map<Class<?>, Object> facets() {
    return Map.of(Configuration.class, this);
  }

  // ---- Facets

  @Override
  public List<Parameter> parameters() {
    return List.of();
  }

  @Override
  public Object get(String name) {
    return Settings.named(parameters(), name);
  }

  @Override
  public void set(String name, Object value) {
    Settings.named(parameters(), name);
  }

  @Override
  public String text() {
    return "camera = " + info.model() + " " + info.serial() + "\n";
  }
}
