package haltere.device.model;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.ClockSync;
import haltere.core.camera.Configuration;
import haltere.core.camera.EarlyTransfer;
import haltere.core.camera.RegionOfInterest;
import haltere.core.camera.TimestampReset;
import haltere.device.protocol.DavisDecoder;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.UsbTransport;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.LongConsumer;

/** Driver of a DAVIS240 or DAVIS346 with logic version 18, by module and parameter. */
final class DavisDriver
    implements CameraDriver, TimestampReset, RegionOfInterest, ClockSync, EarlyTransfer {
  private static final DataEndpoint ENDPOINT = new DataEndpoint(0x82, 32, 8192);

  private static final int RUN = 0;
  private static final int RUN_CLOCK = 1;
  private static final int RESET_CLOCK = 2;
  private static final int CHIP_POWER = 3;
  private static final int USB_RUN = 0;
  private static final int REGION = 41;

  /** Parameters of the chip and their usual values; the last two exist only in the DAVIS346. */
  private static final int[][] CHIP = {
    {128, 0}, {129, 0}, {130, 0}, {131, 0}, {132, 0}, {133, 0}, {134, 0}, {135, 0}, {136, 1},
    {137, 0}, {138, 1}, {140, 0}, {141, 0}, {142, 1}, {143, 1}, {144, 0}
  };

  private static final int FIRST_OF_DAVIS346 = 143;
  private static final long SETTLE_NANOS = TimeUnit.MILLISECONDS.toNanos(10);
  private static final long POWER_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
  private static final long CLOCK_NANOS = TimeUnit.MILLISECONDS.toNanos(50);

  private final CameraInfo info;
  private final DavisIdentity identity;
  private final LongConsumer pause;
  private final ControlLine line = new ControlLine();
  private final DavisRegisters registers = new DavisRegisters(line);
  private final DavisBiases biases;
  private final DavisSettings settings;
  private volatile Optional<Region> region = Optional.empty();

  /**
   * A driver.
   *
   * @param info of the camera
   * @param identity of the camera
   * @param pause waits for a number of nanoseconds
   */
  DavisDriver(CameraInfo info, DavisIdentity identity, LongConsumer pause) {
    this.info = info;
    this.identity = identity;
    this.pause = pause;
    biases = new DavisBiases(registers, identity.isSmall());
    settings =
        new DavisSettings(
            registers, identity, biases, "camera = " + info.model() + " " + info.serial());
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
    DavisDecoder decoder = new DavisDecoder(identity.layout(), samples);
    decoder.awaitReset();
    return decoder;
  }

  @Override
  public void connect(UsbTransport transport) throws CameraProblem {
    line.connect(transport);
    stop();
    biases.send();
    for (int[] parameter : CHIP) {
      if (parameter[0] < FIRST_OF_DAVIS346 || !identity.isSmall()) {
        registers.set(DavisRegisters.BIASES, parameter[0], parameter[1]);
      }
    }
    settings.send();
    sendRegion();
  }

  @Override
  public void start(Runnable startTransfers) throws CameraProblem {
    pause.accept(SETTLE_NANOS);
    line.transport().clearHalt(ENDPOINT.address());
    startTransfers.run();
    registers.set(DavisRegisters.MULTIPLEXER, CHIP_POWER, 1);
    pause.accept(POWER_NANOS);
    registers.set(DavisRegisters.USB, USB_RUN, 1);
    registers.set(DavisRegisters.MULTIPLEXER, RUN_CLOCK, 1);
    registers.set(DavisRegisters.MULTIPLEXER, RUN, 1);
    pause.accept(CLOCK_NANOS);
    resetTimestamps();
    settings.setStreaming(true);
  }

  @Override
  public void stop() throws CameraProblem {
    settings.setStreaming(false);
    registers.set(DavisRegisters.MULTIPLEXER, RUN, 0);
    registers.set(DavisRegisters.MULTIPLEXER, RUN_CLOCK, 0);
    registers.set(DavisRegisters.USB, USB_RUN, 0);
    registers.set(DavisRegisters.MULTIPLEXER, CHIP_POWER, 0);
  }

  @Override
  public void disconnect() {
    line.disconnect();
  }

  @Override
  public Map<Class<?>, Object> facets() {
    Map<Class<?>, Object> facets = new HashMap<>();
    facets.put(Biases.class, biases);
    facets.put(BiasSliders.class, biases);
    facets.put(Configuration.class, settings);
    facets.put(TimestampReset.class, this);
    facets.put(ClockSync.class, this);
    facets.put(EarlyTransfer.class, this);
    if (identity.hasRegion()) {
      facets.put(RegionOfInterest.class, this);
    }
    return facets;
  }

  // ---- Facets

  @Override
  public void resetTimestamps() throws CameraProblem {
    registers.pulse(DavisRegisters.MULTIPLEXER, RESET_CLOCK);
  }

  @Override
  public boolean isMaster() throws CameraProblem {
    return registers.get(DavisRegisters.SYSTEM, 2) != 0;
  }

  @Override
  public void setMaster(boolean master) throws CameraProblem {
    if (master != isMaster()) {
      throw new CameraProblem(
          CameraProblem.Kind.REFUSED,
          "the plugs of a DAVIS determine whether it is the master; change the cable");
    }
  }

  @Override
  public int maxDelayUs() {
    return (Integer) settings.get(DavisSettings.EARLY_DELAY);
  }

  @Override
  public void setMaxDelayUs(int delayUs) throws CameraProblem {
    int steps = Math.max(1, Math.round((float) delayUs / DavisSettings.DELAY_STEP_US));
    settings.set(DavisSettings.EARLY_DELAY, steps * DavisSettings.DELAY_STEP_US);
  }

  @Override
  public Optional<Region> region() {
    return region;
  }

  @Override
  public void setRegion(Optional<Region> newRegion) throws CameraProblem {
    if (newRegion.isPresent()) {
      Region wanted = newRegion.get();
      if (wanted.left() + wanted.width() > info.geometry().width()
          || wanted.bottom() + wanted.height() > info.geometry().height()) {
        throw new IllegalArgumentException(wanted + " is not on " + info.geometry());
      }
    }
    Optional<Region> before = region;
    region = newRegion;
    try {
      sendRegion();
    } catch (CameraProblem problem) {
      region = before;
      throw problem;
    }
  }

  /**
   * Sends the region; the logic counts rows from the top, with inclusive ends, and may swap rows
   * and columns.
   */
  private void sendRegion() throws CameraProblem {
    if (!identity.hasRegion()) {
      return;
    }
    int width = info.geometry().width();
    int height = info.geometry().height();
    Region wanted = region.orElse(new Region(0, 0, width, height));
    int left = wanted.left();
    int right = left + wanted.width() - 1;
    int top = height - wanted.bottom() - wanted.height();
    int bottom = height - wanted.bottom() - 1;
    int[] ends =
        identity.layout().swapped()
            ? new int[] {top, left, bottom, right}
            : new int[] {left, top, right, bottom};
    for (int i = 0; i < ends.length; i++) {
      registers.set(DavisRegisters.EVENTS, REGION + i, ends[i]);
    }
  }
}
