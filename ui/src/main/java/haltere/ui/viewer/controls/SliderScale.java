package haltere.ui.viewer.controls;

import haltere.core.settings.Parameter;

/**
 * Where a number stands on a slider from 0 to 1: in equal differences, or in equal ratios where the
 * setting says so.
 *
 * @param min value at 0
 * @param max value at 1
 * @param least smallest value that has a place of its own on a logarithmic slider; all below are at
 *     0
 * @param logarithmic whether equal ratios take equal ways
 * @param whole whether values are rounded to whole numbers
 */
record SliderScale(double min, double max, double least, boolean logarithmic, boolean whole) {
  /** Ratio that a logarithmic slider spans at most. */
  private static final double SPAN = 1e6;

  static SliderScale of(Parameter parameter) {
    boolean whole = parameter.type() != double.class;
    double min = parameter.min();
    double max = parameter.max();
    double least = min > 0 ? min : whole ? 1 : max / SPAN;
    return new SliderScale(
        min, max, least, parameter.logarithmic() && max > least && max > 0, whole);
  }

  /** The value at a place. */
  double value(double position) {
    double value;
    if (!logarithmic) {
      value = min + (max - min) * position;
    } else if (position <= 0) {
      value = min;
    } else {
      value = least * Math.pow(max / least, position);
    }
    double rounded = whole ? Math.rint(value) : threeDigits(value);
    return Math.max(min, Math.min(max, rounded));
  }

  /** The place of a value. */
  double position(double value) {
    double position =
        !logarithmic
            ? (value - min) / (max - min)
            : value <= least ? 0 : Math.log(value / least) / Math.log(max / least);
    return Math.max(0, Math.min(1, position));
  }

  /** A slider's pixel is no reason for more digits. */
  private static double threeDigits(double value) {
    if (value == 0) {
      return 0;
    }
    return new java.math.BigDecimal(value).round(new java.math.MathContext(3)).doubleValue();
  }
}
