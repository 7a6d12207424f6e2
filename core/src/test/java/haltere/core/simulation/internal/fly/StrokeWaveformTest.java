package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** The published waveforms have their published figures. */
class StrokeWaveformTest {
  @ParameterizedTest
  @CsvSource({
    "MUIJRES, 131.6, 0.537",
    "FRY, 143.4, 0.538",
    "MAEDA, 143.5, 0.538",
    "CHEN_SUN, 129.6, 0.559",
    "SINUSOID, 120.0, 0.5"
  })
  void publishedStrokeHasItsAmplitudeAndDownstrokeShare(
      StrokeWaveform waveform, double peakToPeakDeg, double share) {
    Waveform published = waveform.published();

    assertEquals(peakToPeakDeg, published.max() - published.min(), 0.2);
    assertEquals(share, published.shareFromMaxToMin(), 0.0015);
  }

  @ParameterizedTest
  @CsvSource({"MUIJRES, 3.3, 3.4", "FRY, 3.0, 3.3", "MAEDA, 3.0, 3.35", "CHEN_SUN, 6.8, 7.0"})
  void bestSinusoidLeavesTheComputedResidual(
      StrokeWaveform waveform, double leastDeg, double mostDeg) {
    double residual = residualOfBestSinusoid(waveform.published());

    assertTrue(residual >= leastDeg && residual <= mostDeg, residual + " degrees");
  }

  @ParameterizedTest
  @EnumSource(StrokeWaveform.class)
  void normalisedStrokePassesItsMeanAtPhaseZero(StrokeWaveform waveform) {
    Waveform normal = waveform.normalised(HarmonicSettings.defaults());

    assertEquals(0, normal.at(0), 1e-12);
    assertTrue(normal.slopeAt(0) > 0.5);
    assertEquals(2, normal.max() - normal.min(), 1e-9);
    double sum = 0;
    for (int i = 0; i < 1000; i++) {
      sum += normal.at(2 * Math.PI * i / 1000);
    }
    assertEquals(0, sum, 1e-9);
  }

  @ParameterizedTest
  @EnumSource(StrokeWaveform.class)
  void slopeIsTheDerivativeOfTheStroke(StrokeWaveform waveform) {
    Waveform normal = waveform.normalised(HarmonicSettings.defaults());

    for (double phase = 0; phase < 6.28; phase += 0.1) {
      double difference = (normal.at(phase + 1e-5) - normal.at(phase - 1e-5)) / 2e-5;
      assertEquals(difference, normal.slopeAt(phase), 1e-8);
    }
  }

  @Test
  void freeStrokeHasTheConfiguredHarmonics() {
    Waveform normal = StrokeWaveform.FREE.normalised(new HarmonicSettings(0.15, 0.4, 0.05, -1));

    double first = magnitude(normal, 1);
    assertEquals(0.15, magnitude(normal, 2) / first, 1e-9);
    assertEquals(0.05, magnitude(normal, 3) / first, 1e-9);
  }

  private static double magnitude(Waveform waveform, int harmonic) {
    int n = 720;
    double c = 0;
    double s = 0;
    for (int i = 0; i < n; i++) {
      double phase = 2 * Math.PI * i / n;
      c += waveform.at(phase) * Math.cos(harmonic * phase) * 2 / n;
      s += waveform.at(phase) * Math.sin(harmonic * phase) * 2 / n;
    }
    return Math.hypot(c, s);
  }

  private static double residualOfBestSinusoid(Waveform waveform) {
    double first = magnitude(waveform, 1);
    int n = 720;
    double square = 0;
    for (int i = 0; i < n; i++) {
      square += Math.pow(waveform.at(2 * Math.PI * i / n), 2) / n;
    }
    return Math.sqrt(square - first * first / 2);
  }
}
