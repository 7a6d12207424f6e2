package haltere.testing.wings;

import java.util.List;
import java.util.function.ToDoubleFunction;

/** Quantiles of a figure over scenes. */
final class Quantiles {
  private Quantiles() {}

  /** Value that a share of the rows does not exceed; NaN of none. */
  static <T> double of(List<T> rows, ToDoubleFunction<T> value, double share) {
    double[] values = rows.stream().mapToDouble(value).sorted().toArray();
    return values.length == 0
        ? Double.NaN
        : values[(int) Math.min(values.length - 1, Math.floor(share * values.length))];
  }
}
