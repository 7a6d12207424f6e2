package haltere.ui.viewer.controls;

import haltere.core.settings.Parameter;

/**
 * Maps a number to a slider from 0 to 1, linearly or logarithmically as the setting states.
 *
 * @param min value at 0
 * @param max value at 1
 * @param minPositive smallest value that has a place of its own on a logarithmic slider; all below
 *     are at 0
 * @param logarithmic whether equal ratios take equal ways
 * @param whole whether values are rounded to whole numbers
 */
record SliderScale(double min, double max, double minPositive, boolean logarithmic, boolean whole) {
  /** Ratio that a logarithmic slider spans at most. */
  private static final double SPAN = 1e6;

  static SliderScale of(Parameter parameter) {
    boolean whole = parameter.type() != double.class;
    double min = parameter.min();
    double max = parameter.max();
    double minPositive = min > 0 ? min : whole ? 1 : max / SPAN;
    return new SliderScale(
        min, max, minPositive, parameter.logarithmic() && max > minPositive && max > 0, whole);
  }

  double value(double position) {
    double value;
    if (!logarithmic) {
      value = min + (max - min) * position;
    } else if (position <= 0) {
      value = min;
    } else {
      value = minPositive * Math.pow(max / minPositive, position);
    }
    double rounded = whole ? Math.rint(value) : threeDigits(value);
    return Math.max(min, Math.min(max, rounded));
  }

  double position(double value) {
    double position =
        !logarithmic
            ? (value - min) / (max - min)
            : value <= minPositive
                ? 0
                : Math.log(value / minPositive) / Math.log(max / minPositive);
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
