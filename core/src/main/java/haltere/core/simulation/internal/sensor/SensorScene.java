package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.stream.StreamHandler;

/**
 * A scene seen by a {@link SceneSensor}, made interval by interval as it is pulled.
 *
 * @param <T> the record of one row of ground truth
 */
public abstract class SensorScene<T extends Record> implements TunableScene<T> {
  /** Default of the largest number of events of a packet. */
  protected static final int MAX_EVENTS = 4096;

  private final SceneSensor<?> sensor;
  private final RunSettings run;
  private final PacketCutter cutter;
  private long doneUs;

  /**
   * A scene at its beginning.
   *
   * @param name its name in notifications
   * @param sensor its sensor
   * @param run seed, start and length
   * @param maxEvents maximum number of events of a packet
   */
  protected SensorScene(String name, SceneSensor<?> sensor, RunSettings run, int maxEvents) {
    this.sensor = sensor;
    this.run = run;
    cutter = new PacketCutter(run, sensor.geometry(), name, maxEvents, this::interval);
  }

  /**
   * Makes the next interval.
   *
   * @param fromUs its start, microseconds from the scene's start
   * @param sensor the sensor of the scene
   * @param out receives the events that are complete at its end
   * @return its end, microseconds from the scene's start
   */
  protected abstract long makeInterval(long fromUs, SceneSensor<?> sensor, EventPacket out);

  private long interval(EventPacket out) {
    doneUs = makeInterval(doneUs, sensor, out);
    return doneUs;
  }

  @Override
  public final SensorGeometry geometry() {
    return sensor.geometry();
  }

  @Override
  public final boolean next(StreamHandler handler) {
    return cutter.next(handler);
  }

  @Override
  public final SensorTuning tuning() {
    return sensor.tuning();
  }

  @Override
  public final void tune(SensorTuning newTuning) {
    sensor.tune(newTuning, doneUs);
  }

  @Override
  public final RunSettings run() {
    return run;
  }
}
