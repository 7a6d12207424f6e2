package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/** Reports each beat at its end, when the phase passes 0. */
final class BeatClock {
  private final WingPart side;
  private final BeatListener beats;
  private double lastPhase;
  private double lastCrossingUs = Double.NaN;

  BeatClock(WingPart side, BeatListener beats) {
    this.side = side;
    this.beats = beats;
  }

  /** Starts at a phase. */
  void launch(double phase) {
    lastPhase = phase;
    lastCrossingUs = Double.NaN;
  }

  /** Processes a phase in [0, 2 pi), several times a beat. */
  void update(long timeUs, double phase, double omega, StrokeShape shape) {
    if (phase < lastPhase - Math.PI) {
      double crossingUs = timeUs - phase / omega * 1e6;
      beats.beat(side, crossingUs, crossingUs - lastCrossingUs, shape.min, shape.max);
      lastCrossingUs = crossingUs;
      lastPhase = phase;
    } else if (phase - lastPhase < Math.PI) {
      lastPhase = Math.max(lastPhase, phase);
    }
  }
}
