package haltere.filters.estimation;

/**
 * The regularised incomplete gamma functions P(a, x) and Q(a, x) = 1 − P(a, x), to about 1e-13
 * relative in the tail that is asked for.
 *
 * <p>Series for x below a + 1, continued fraction (modified Lentz) above: Abramowitz and Stegun
 * (1964), 6.5.29 and 6.5.31. The factor before both, xᵃ e⁻ˣ / Γ(a), is written around x = a for
 * large a, where its plain form would lose digits: Temme (1994), "A set of algorithms for the
 * incomplete gamma functions", eq. 3.2 and 5.1.
 */
final class IncompleteGamma {
  private static final double EPSILON = 1e-16;
  private static final double TINY = 1e-300;
  private static final double HALF_LOG_TWO_PI = 0.5 * Math.log(2 * Math.PI);
  private static final int MAX_TERMS = 1_000_000;

  private IncompleteGamma() {}

  /** P(a, x), the lower tail. */
  static double lower(double a, double x) {
    if (x <= 0) {
      return 0;
    }
    return x < a + 1 ? series(a, x) : 1 - continuedFraction(a, x);
  }

  /** Q(a, x), the upper tail. */
  static double upper(double a, double x) {
    if (x <= 0) {
      return 1;
    }
    return x < a + 1 ? 1 - series(a, x) : continuedFraction(a, x);
  }

  /** Derivative of P(a, x) by x: xᵃ⁻¹ e⁻ˣ / Γ(a). */
  static double density(double a, double x) {
    return factor(a, x) / x;
  }

  private static double series(double a, double x) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n < MAX_TERMS && term > sum * EPSILON; n++) {
      term *= x / (a + n);
      sum += term;
    }
    return Math.min(1, sum * factor(a, x));
  }

  private static double continuedFraction(double a, double x) {
    double b = x + 1 - a;
    double c = 1 / TINY;
    double d = 1 / b;
    double h = d;
    for (int i = 1; i < MAX_TERMS; i++) {
      double numerator = -i * (i - a);
      b += 2;
      d = 1 / nonZero(numerator * d + b);
      c = nonZero(b + numerator / c);
      double delta = c * d;
      h *= delta;
      if (Math.abs(delta - 1) <= EPSILON) {
        break;
      }
    }
    return Math.min(1, h * factor(a, x));
  }

  private static double nonZero(double value) {
    return Math.abs(value) < TINY ? TINY : value;
  }

  /** xᵃ e⁻ˣ / Γ(a). */
  private static double factor(double a, double x) {
    if (a < 10) {
      return Math.exp(a * Math.log(x) - x - logGamma(a));
    }
    // Γ(a) = √(2π/a) (a/e)ᵃ e^{δ(a)}, so the exponent is −a (μ − ln(1 + μ)) with μ = x/a − 1.
    double mu = (x - a) / a;
    return Math.exp(-a * logDeviation(mu) - stirlingRest(a)) * Math.sqrt(a / (2 * Math.PI));
  }

  /** μ − ln(1 + μ), without cancellation near 0. */
  private static double logDeviation(double mu) {
    if (Math.abs(mu) > 0.1) {
      return mu - Math.log1p(mu);
    }
    double power = mu * mu;
    double sum = power / 2;
    for (int k = 3; k < 40; k++) {
      power *= -mu;
      double term = power / k;
      sum += term;
      if (Math.abs(term) < sum * EPSILON) {
        break;
      }
    }
    return sum;
  }

  /** ln Γ(a) for a > 0. */
  static double logGamma(double a) {
    double shift = 0;
    double b = a;
    while (b < 10) {
      shift += Math.log(b);
      b++;
    }
    return (b - 0.5) * Math.log(b) - b + HALF_LOG_TWO_PI + stirlingRest(b) - shift;
  }

  /** What Stirling's formula leaves of ln Γ(a), a at least 10: Abramowitz and Stegun 6.1.41. */
  private static double stirlingRest(double a) {
    double i2 = 1 / (a * a);
    return (1.0 / 12
            - i2
                * (1.0 / 360
                    - i2
                        * (1.0 / 1260
                            - i2
                                * (1.0 / 1680
                                    - i2
                                        * (1.0 / 1188
                                            - i2 * (691.0 / 360360 - i2 * (1.0 / 156)))))))
        / a;
  }
}
