package haltere.device.model;

import haltere.core.camera.ArrayReset;
import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.ClockSync;
import haltere.core.camera.Configuration;
import haltere.core.camera.EarlyTransfer;
import haltere.core.camera.Led;
import haltere.core.camera.TimestampReset;
import haltere.device.protocol.Dvs128Decoder;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.UsbTransport;
import java.util.Map;

/**
 * Driver of a DVS128 by vendor requests. Since firmware 14 its clock runs and its queue keeps old
 * events while it is stopped. Each start therefore empties the queue, then resets the clock, and
 * drops words before the reset.
 */
final class Dvs128Driver
    implements CameraDriver, TimestampReset, ArrayReset, Led, ClockSync, EarlyTransfer {
  private static final int START = 0xb3;
  private static final int STOP = 0xb4;
  private static final int BIASES_OFF = 0xb9;
  private static final int RESET_TIMESTAMPS = 0xbb;
  private static final int HOLD_ARRAY = 0xbc;
  private static final int PULSE_ARRAY = 0xbd;
  private static final int MASTER = 0xbe;
  private static final int EMPTY_QUEUE = 0xc4;
  private static final int GET_MASTER = 0xcb;
  private static final int LED = 0xcd;

  private static final DataEndpoint ENDPOINT = new DataEndpoint(0x86, 16, 4096);

  /** The first firmware that sends partial transfers after 1 ms instead of 4 ms. */
  private static final int FIRMWARE_OF_EARLY_TIMER = 10;

  private static final int FIRMWARE_OF_SYNC = 11;
  private static final int FIRMWARE_OF_LED = 12;

  private final CameraInfo info;
  private final int firmware;
  private final ControlLine line = new ControlLine();
  private final Dvs128Biases biases = new Dvs128Biases(line);
  private final Dvs128Settings settings = new Dvs128Settings(this, biases);
  private volatile boolean master = true;
  private volatile boolean holding;
  private volatile Led.LedState led = Led.LedState.ON;

  Dvs128Driver(CameraInfo info, int firmware) {
    this.info = info;
    this.firmware = firmware;
  }

  int firmware() {
    return firmware;
  }

  boolean wantsMaster() {
    return master;
  }

  boolean isHolding() {
    return holding;
  }

  Led.LedState led() {
    return led;
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
    Dvs128Decoder fresh = new Dvs128Decoder(samples);
    if (master) {
      fresh.awaitReset(); // a slave's clock is reset only by its master
    }
    return fresh;
  }

  @Override
  public void connect(UsbTransport transport) throws CameraProblem {
    line.connect(transport);
    line.send(STOP, 0, 0);
    line.send(BIASES_OFF, 0, 0);
    biases.send();
    if (firmware >= FIRMWARE_OF_SYNC) {
      line.send(MASTER, master ? 1 : 0, 0);
    }
    line.send(HOLD_ARRAY, holding ? 1 : 0, 0);
    if (firmware >= FIRMWARE_OF_LED) {
      line.send(LED, led.ordinal(), 0); // the start drops the false trigger
    }
  }

  @Override
  public void start(Runnable startTransfers) throws CameraProblem {
    emptyQueue();
    startTransfers.run();
    line.send(START, 0, 0);
    line.send(RESET_TIMESTAMPS, 0, 0);
  }

  private void emptyQueue() throws CameraProblem {
    try {
      line.send(EMPTY_QUEUE, 0, 0);
    } catch (CameraProblem problem) {
      // old firmware lacks the request; the clock reset separates old from new events too
      if (problem.kind() != CameraProblem.Kind.REFUSED) {
        throw problem;
      }
    }
  }

  @Override
  public void stop() throws CameraProblem {
    line.send(STOP, 0, 0);
    emptyQueue();
  }

  @Override
  public void disconnect() {
    line.disconnect();
  }

  @Override
  public Map<Class<?>, Object> facets() {
    return Map.of(
        Biases.class, biases,
        BiasSliders.class, biases,
        TimestampReset.class, this,
        ArrayReset.class, this,
        Led.class, this,
        ClockSync.class, this,
        EarlyTransfer.class, this,
        Configuration.class, settings);
  }

  // ---- Facets

  @Override
  public void resetTimestamps() throws CameraProblem {
    line.send(RESET_TIMESTAMPS, 0, 0);
  }

  @Override
  public void resetPixels() throws CameraProblem {
    line.send(PULSE_ARRAY, 0, 0);
  }

  @Override
  public void holdPixels(boolean hold) throws CameraProblem {
    line.send(HOLD_ARRAY, hold ? 1 : 0, 0);
    holding = hold;
  }

  /** {@inheritDoc} Firmware from 13 on then sends a false trigger. */
  @Override
  public void setLed(Led.LedState state) throws CameraProblem {
    if (firmware < FIRMWARE_OF_LED) {
      throw unsupported("switch its LED", FIRMWARE_OF_LED);
    }
    line.send(LED, state.ordinal(), 0);
    led = state;
  }

  @Override
  public boolean isMaster() throws CameraProblem {
    return line.query(GET_MASTER, 0, 0, 2)[1] != 0;
  }

  @Override
  public void setMaster(boolean newMaster) throws CameraProblem {
    if (firmware < FIRMWARE_OF_SYNC) {
      throw unsupported("follow another clock", FIRMWARE_OF_SYNC);
    }
    line.send(MASTER, newMaster ? 1 : 0, 0);
    master = newMaster;
  }

  private CameraProblem unsupported(String what, int from) {
    return new CameraProblem(
        CameraProblem.Kind.UNSUPPORTED,
        "this DVS128 has firmware " + firmware + ", which cannot " + what + "; " + from + " can");
  }

  @Override
  public int maxDelayUs() {
    return firmware >= FIRMWARE_OF_EARLY_TIMER ? 1000 : 4000;
  }

  @Override
  public void setMaxDelayUs(int delayUs) {
    if (delayUs != maxDelayUs()) {
      throw new IllegalArgumentException(
          "the firmware of this DVS128 sends what it has after "
              + maxDelayUs()
              + " us, not after "
              + delayUs);
    }
  }
}
