package haltere.ui.plot;

import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * Stores the inertial samples of a stream until the window fetches them as curves, one for each
 * axis.
 *
 * <p>Thread rule: samples come on the processing thread; all else is for one other thread.
 */
public final class InertialFeed {
  /** Acceleration along the three axes, standard gravities. */
  public static final PlotField ACCELERATION = field("acceleration_g");

  /** Rate of rotation about the three axes, degrees per second. */
  public static final PlotField ROTATION = field("rotation_deg_s");

  /** Temperature of the sensor, degrees Celsius. */
  public static final PlotField TEMPERATURE = field("temperature_c");

  /** All that can be plotted. */
  public static final List<PlotField> FIELDS = List.of(ACCELERATION, ROTATION, TEMPERATURE);

  private static final int CAPACITY = 1 << 13;

  private final Map<PlotField, SampleQueue> queues =
      FIELDS.stream().collect(Collectors.toMap(field -> field, field -> new SampleQueue(CAPACITY)));
  private volatile boolean any;

  private static PlotField field(String column) {
    return new PlotField("inertial-sensor", "samples", column);
  }

  /** Whether there are samples. */
  public boolean hasSamples() {
    return any;
  }

  /** Takes an inertial sample; other readings are ignored. */
  public void take(SensorSample taken) {
    if (taken instanceof InertialSample sample) {
      any = true;
      long timeUs = sample.timeUs();
      SampleQueue acceleration = queues.get(ACCELERATION);
      SampleQueue rotation = queues.get(ROTATION);
      acceleration.put(timeUs, "x", sample.accelerationXG());
      acceleration.put(timeUs, "y", sample.accelerationYG());
      acceleration.put(timeUs, "z", sample.accelerationZG());
      rotation.put(timeUs, "x", sample.rotationXDegS());
      rotation.put(timeUs, "y", sample.rotationYDegS());
      rotation.put(timeUs, "z", sample.rotationZDegS());
      queues.get(TEMPERATURE).put(timeUs, "", sample.temperatureC());
    }
  }

  /** Passes the samples of one of the {@link #FIELDS} since the last call, oldest first. */
  public void drainTo(PlotField field, SampleQueue.SampleConsumer consumer) {
    queues.get(field).drainTo(consumer);
  }
}
