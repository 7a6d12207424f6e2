package haltere.filters.wing.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SineCosineTest {
  private final SineCosine both = new SineCosine();

  @ParameterizedTest
  @ValueSource(doubles = {0.8, 7, 1e3, SineCosine.GREATEST_ANGLE, 1e9})
  void theyAreThoseOfTheLibraryForAnglesUpTo(double greatest) {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 20_000; i++) {
      double angle = random.nextDouble(-greatest, greatest);
      both.of(angle);
      assertEquals(StrictMath.sin(angle), both.sine(), 4e-16, "sine of " + angle);
      assertEquals(StrictMath.cos(angle), both.cosine(), 4e-16, "cosine of " + angle);
    }
  }

  @Test
  void eachQuarterOfATurnIsExact() {
    for (int quarter = -1000; quarter <= 1000; quarter++) {
      double angle = quarter * (Math.PI / 2);
      both.of(angle);
      assertEquals(StrictMath.sin(angle), both.sine(), 4e-16, "sine of " + angle);
      assertEquals(StrictMath.cos(angle), both.cosine(), 4e-16, "cosine of " + angle);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void whatHasNoDirectionHasNoSine(double angle) {
    both.of(angle);
    assertTrue(Double.isNaN(both.sine()) && Double.isNaN(both.cosine()));
  }
}
