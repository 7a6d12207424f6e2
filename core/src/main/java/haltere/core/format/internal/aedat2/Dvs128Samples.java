package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;

/**
 * The DVS128 marks edges on its input only; which way they go it does not tell, and its light
 * emitting diode makes some too.
 */
final class Dvs128Samples implements AedatSampleCursor.SampleAssembly {
  @Override
  public SensorSample take(int word, long timeUs, long offset) {
    return new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 0);
  }

  @Override
  public void reset() {
    // Each word is a whole mark.
  }
}
