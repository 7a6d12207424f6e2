package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/** Tells of each beat as it ends: when the phase has passed 0. */
final class BeatClock {
  private final WingPart side;
  private final BeatListener beats;
  private double lastPhase;
  private double lastCrossingUs = Double.NaN;

  BeatClock(WingPart side, BeatListener beats) {
    this.side = side;
    this.beats = beats;
  }

  /** Begins at a phase. */
  void launch(double phase) {
    lastPhase = phase;
    lastCrossingUs = Double.NaN;
  }

  /** Looks, several times a beat, at the phase in [0, 2 pi). */
  void look(long timeUs, double phase, double omega, StrokeShape shape) {
    if (phase < lastPhase - Math.PI) {
      double crossingUs = timeUs - phase / omega * 1e6;
      beats.beat(side, crossingUs, crossingUs - lastCrossingUs, shape.least, shape.most);
      lastCrossingUs = crossingUs;
      lastPhase = phase;
    } else if (phase - lastPhase < Math.PI) {
      lastPhase = Math.max(lastPhase, phase);
    }
  }
}
