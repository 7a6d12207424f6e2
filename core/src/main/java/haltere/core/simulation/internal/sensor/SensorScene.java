package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.stream.StreamHandler;

/**
 * A scene before a {@link SceneSensor}, made interval by interval as it is pulled.
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
   * @param name what its notifications call it
   * @param sensor what sees it
   * @param run seed, start and length
   * @param mostEvents of a packet
   */
  protected SensorScene(String name, SceneSensor<?> sensor, RunSettings run, int mostEvents) {
    this.sensor = sensor;
    this.run = run;
    cutter = new PacketCutter(run, sensor.geometry(), name, mostEvents, this::interval);
  }

  /**
   * Makes what happens in the next interval.
   *
   * @param fromUs where it begins, microseconds from the scene's start
   * @param sensor sees it
   * @param out gets the events that are certain by its end
   * @return where it ends
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
