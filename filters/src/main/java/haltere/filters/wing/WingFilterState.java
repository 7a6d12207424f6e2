package haltere.filters.wing;

import haltere.filters.estimation.ConstMatrix;
import java.util.List;

/**
 * Present numbers of a Kalman filter; {@link haltere.filters.wing.tracker.WingTracker#edit
 * WingTracker.edit} changes them.
 *
 * @param part the wing, or the edge with a filter for each edge
 * @param names of the entries of the state
 * @param units of the entries of the state
 * @param x the state
 * @param p the covariance
 * @param q present process noise of each entry: a density in squared units a second, or the
 *     variance per update with {@link WingModel#ORIGINAL}
 * @param qUnits of the process noise
 * @param qSources source of each number of the process noise
 * @param r present variance of a measurement, squared radians
 * @param rSource source of the variance of a measurement
 * @param nis recent mean normalised innovation squared; NaN if unknown
 * @param events number of used events
 */
public record WingFilterState(
    WingPart part,
    List<String> names,
    List<String> units,
    ConstMatrix x,
    ConstMatrix p,
    ConstMatrix q,
    List<String> qUnits,
    List<Source> qSources,
    double r,
    Source rSource,
    double nis,
    long events) {
  /** Source of a number of the noise. */
  public enum Source {
    /** The settings. */
    SETTINGS,
    /** Estimated from the events. */
    ESTIMATOR,
    /** Set manually. */
    MANUAL
  }

  public WingFilterState {
    names = List.copyOf(names);
    units = List.copyOf(units);
    qUnits = List.copyOf(qUnits);
    qSources = List.copyOf(qSources);
  }

  /**
   * A number of a table.
   *
   * @param table the table
   * @param row from 0
   * @param column from 0; used for the covariance only
   * @return the number
   */
  public double value(WingFilterEdit.Table table, int row, int column) {
    return switch (table) {
      case STATE -> x.get(row);
      case COVARIANCE -> p.get(row, column);
      case PROCESS_NOISE -> q.get(row);
      case MEASUREMENT_NOISE -> r;
    };
  }

  /**
   * Source of a number of the noise.
   *
   * @param table of the noise
   * @param row from 0
   * @return {@link Source#SETTINGS} for state and covariance
   */
  public Source source(WingFilterEdit.Table table, int row) {
    return switch (table) {
      case PROCESS_NOISE -> qSources.get(row);
      case MEASUREMENT_NOISE -> rSource;
      default -> Source.SETTINGS;
    };
  }
}
