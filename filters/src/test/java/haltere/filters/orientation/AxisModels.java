package haltere.filters.orientation;

import haltere.filters.orientation.internal.axis.AxisModel;

/** Models of the axis by the settings of an estimator. */
public final class AxisModels {
  private AxisModels() {}

  public static AxisModel of(OrientationSettings settings) {
    return settings.axisModel();
  }
}
