package haltere.core.simulation.internal.fly;

/**
 * Stroke angle over the cycle as published fits give it (cosine and sine terms in degrees, largest
 * angle nearest to the tail). The coefficients are those in the repositories of xijunke and of
 * WABBIT (adaptive-cfd); the constant term is left out, the scene sets the centre itself.
 */
public enum StrokeWaveform {
  /** Free flight of D. hydei at 188.7 Hz, fit of Muijres 2014. */
  MUIJRES(new double[] {65.04, 3.58, 0.13, 0.78}, new double[] {4.26, -2.95, 0.36, 0.21}),
  /** Hovering D. melanogaster, Fry 2005, digitised. */
  FRY(new double[] {71.11, 2.17, -0.20, 0.61}, new double[] {5.45, -3.55, 0.63, 0.16}),
  /** Hovering D. melanogaster, Maeda. */
  MAEDA(new double[] {71.06, 2.07, -0.21, 0}, new double[] {5.09, -4.01, 0.72, 0}),
  /** A beat of take-off, Chen and Sun 2014. */
  CHEN_SUN(new double[] {-60.48, -5.34, -2.79, 0.33}, new double[] {3.00, -7.55, -1.33, -0.30}),
  /** A plain sinusoid. */
  SINUSOID(new double[] {0, 0, 0, 0}, new double[] {60, 0, 0, 0}),
  /** A sinusoid with a second and a third harmonic by the settings. */
  FREE(new double[] {0, 0, 0, 0}, new double[] {60, 0, 0, 0});

  private final double[] cosines;
  private final double[] sines;

  StrokeWaveform(double[] cosines, double[] sines) {
    this.cosines = cosines;
    this.sines = sines;
  }

  /** The published terms in degrees, as a waveform of their own scale and phase. */
  Waveform published() {
    return Waveform.ofTerms(cosines, sines);
  }

  /**
   * The normalised waveform.
   *
   * @param harmonics second and third harmonic, used by {@link #FREE} alone
   */
  Waveform normalised(HarmonicSettings harmonics) {
    if (this != FREE) {
      return published().normalised();
    }
    double second = harmonics.second();
    double third = harmonics.third();
    return Waveform.ofTerms(
            new double[] {
              0,
              second * StrictMath.sin(harmonics.secondPhaseRad()),
              third * StrictMath.sin(harmonics.thirdPhaseRad())
            },
            new double[] {
              1,
              second * StrictMath.cos(harmonics.secondPhaseRad()),
              third * StrictMath.cos(harmonics.thirdPhaseRad())
            })
        .normalised();
  }
}
