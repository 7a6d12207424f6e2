package haltere.core.simulation.internal.fly;

/**
 * The pitch of a wing about its long axis over the beat. The chord keeps its angle from the stroke
 * plane in mid stroke and turns over its edge around each reversal, smoothly.
 *
 * <p>Thread rule: immutable.
 */
final class WingPitch {
  private final PitchSettings settings;
  private final double flipRad;
  private final double toHead;
  private final double toTail;

  WingPitch(PitchSettings settings, Waveform waveform) {
    this.settings = settings;
    double back = waveform.shareFromMaxToMin();
    // A flip ends before the next one begins.
    flipRad = 2 * Math.PI * Math.min(settings.flipShare(), Math.min(back, 1 - back));
    toHead = waveform.phaseOfMax() - settings.flipAdvanceRad() - flipRad / 2;
    toTail = waveform.phaseOfMin() - settings.flipAdvanceRad() - flipRad / 2;
  }

  /**
   * The share of the chord that is visible from above.
   *
   * @param phase of the stroke, any
   * @return positive where the leading edge is on the side of the tail
   */
  double projection(double phase) {
    double sinceHead = FlyTruth.wrapped(phase - toHead);
    double sinceTail = FlyTruth.wrapped(phase - toTail);
    double flipped =
        sinceHead < sinceTail ? smooth(sinceHead / flipRad) : 1 - smooth(sinceTail / flipRad);
    double from = settings.towardsTailRad();
    double to = Math.PI - settings.towardsHeadRad();
    return StrictMath.cos(from + (to - from) * flipped);
  }

  private static double smooth(double share) {
    double x = Math.min(1, share);
    return x * x * (3 - 2 * x);
  }
}
