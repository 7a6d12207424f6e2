package haltere.core.format.internal.aedat2;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;

/** Triggers of the DVS128: edges of its input without a direction; its LED causes some as well. */
final class Dvs128Samples implements AedatSampleCursor.SampleAssembly {
  @Override
  public SensorSample take(int word, long timeUs, long offset) {
    return new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 0);
  }

  @Override
  public void reset() {
    // each word is a complete trigger
  }
}
