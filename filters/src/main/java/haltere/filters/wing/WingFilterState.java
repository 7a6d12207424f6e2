package haltere.filters.wing;

import java.util.List;

/**
 * The numbers of a Kalman filter as they are now, to be looked at and changed ({@link
 * haltere.filters.wing.tracker.WingTracker#edit WingTracker.edit}).
 *
 * @param part the wing, or the edge where there is a filter for each edge
 * @param names of the entries of the state
 * @param units of the entries of the state
 * @param x the state; arrays are copied
 * @param p the covariance, row by row
 * @param q process noise of each entry: a density in squared units a second, or what an update adds
 *     if the settings say so
 * @param r variance of a measurement, squared radians: the present one, learnt or set
 * @param learnsR whether the variance of measurements is learnt from the events
 * @param nis mean normalised innovation squared of late; NaN if unknown
 * @param events taken in so far
 */
public record WingFilterState(
    WingPart part,
    List<String> names,
    List<String> units,
    double[] x,
    double[] p,
    double[] q,
    double r,
    boolean learnsR,
    double nis,
    long events) {
  /** Copies the lists and arrays. */
  public WingFilterState {
    names = List.copyOf(names);
    units = List.copyOf(units);
    x = x.clone();
    p = p.clone();
    q = q.clone();
  }

  @Override
  public double[] x() {
    return x.clone();
  }

  @Override
  public double[] p() {
    return p.clone();
  }

  @Override
  public double[] q() {
    return q.clone();
  }

  /**
   * The number of a table.
   *
   * @param table which table
   * @param row from 0
   * @param column from 0; taken by the covariance alone
   * @return the number
   */
  public double value(WingFilterEdit.Table table, int row, int column) {
    return switch (table) {
      case STATE -> x[row];
      case COVARIANCE -> p[row * x.length + column];
      case PROCESS_NOISE -> q[row];
      case MEASUREMENT_NOISE -> r;
    };
  }
}
