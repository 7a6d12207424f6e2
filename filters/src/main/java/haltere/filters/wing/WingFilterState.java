package haltere.filters.wing;

import haltere.filters.estimation.ConstMatrix;
import java.util.List;

/**
 * The numbers of a Kalman filter as they are now, to be looked at and changed ({@link
 * haltere.filters.wing.tracker.WingTracker#edit WingTracker.edit}).
 *
 * @param part the wing, or the edge where there is a filter for each edge
 * @param names of the entries of the state
 * @param units of the entries of the state
 * @param x the state
 * @param p the covariance
 * @param q process noise of each entry that is used now: a density in squared units a second, or
 *     what an update adds with {@link WingModel#ORIGINAL}
 * @param qUnits of the process noise
 * @param qSources where each number of the process noise comes from
 * @param r variance of a measurement that is used now, squared radians
 * @param rSource where the variance of a measurement comes from
 * @param nis mean normalised innovation squared of late; NaN if unknown
 * @param events taken in so far
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
  /** Where a number of the noise comes from. */
  public enum Source {
    /** It follows from the settings. */
    SETTINGS,
    /** The estimator adapts it to the events. */
    ESTIMATOR,
    /** A person has set it. */
    BY_HAND
  }

  public WingFilterState {
    names = List.copyOf(names);
    units = List.copyOf(units);
    qUnits = List.copyOf(qUnits);
    qSources = List.copyOf(qSources);
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
      case STATE -> x.get(row);
      case COVARIANCE -> p.get(row, column);
      case PROCESS_NOISE -> q.get(row);
      case MEASUREMENT_NOISE -> r;
    };
  }

  /**
   * Where a number of the noise comes from.
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
