package haltere.core.sink.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Round numbers for an axis.
 *
 * @param step distance between two ticks, 1, 2 or 5 times a power of ten
 * @param values the ticks within the range, ascending
 */
public record Ticks(double step, List<Double> values) {
  /** Copies the values. */
  public Ticks {
    values = List.copyOf(values);
  }

  /** Ticks of a range, at most a number; none if the range is empty or not finite. */
  public static Ticks of(double from, double to, int max) {
    if (!(to > from) || Double.isInfinite(to - from)) {
      return new Ticks(1, List.of());
    }
    double rough = (to - from) / Math.max(1, max);
    double power = Math.pow(10, Math.floor(Math.log10(rough)));
    double step = 10 * power;
    for (double factor : new double[] {1, 2, 5}) {
      if (factor * power >= rough * (1 - 1e-9)) {
        step = factor * power;
        break;
      }
    }
    List<Double> values = new ArrayList<>();
    long first = (long) Math.ceil(from / step - 1e-9);
    long last = (long) Math.floor(to / step + 1e-9);
    for (long i = first; i <= last && values.size() < max; i++) {
      values.add(i * step);
    }
    return new Ticks(step, values);
  }

  /**
   * Ticks of a range: at most a number if these are two or more; otherwise the coarsest with two or
   * more, which are at most five; none if the range is empty or not finite.
   */
  public static Ticks atLeastTwo(double from, double to, int max) {
    Ticks ticks = of(from, to, Math.max(2, max));
    for (int more = Math.max(2, max) + 1; ticks.values().size() < 2 && more <= 5; more++) {
      ticks = of(from, to, more);
    }
    return ticks;
  }

  /**
   * A value as text, with enough digits to distinguish it from its neighbours, such as 0.25, 40 or
   * 2.5e6.
   */
  public String label(double value) {
    double size = Math.max(Math.abs(value), step);
    if (size >= 1e6 || size < 1e-4) {
      double exponent = Math.floor(Math.log10(size));
      int digits = (int) Math.max(0, exponent - Math.floor(Math.log10(step) + 1e-9));
      return value == 0
          ? "0"
          : String.format(Locale.ROOT, "%." + digits + "e", value)
              .replaceAll("e([+-])0?", "e$1")
              .replace("e+", "e");
    }
    int decimals = (int) Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    return String.format(Locale.ROOT, "%." + decimals + "f", value == 0 ? 0.0 : value);
  }
}
