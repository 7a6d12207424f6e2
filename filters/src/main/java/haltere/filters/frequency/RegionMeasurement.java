package haltere.filters.frequency;

/**
 * Recent event rate and frequency of a region.
 *
 * @param rateEps events per second of recording time
 * @param onShare share of ON events in them, 0 to 1; NaN without events
 * @param frequencyHz repetition frequency of the events; NaN if there is none
 * @param spanUs recording time of the measurement
 * @since 0.1
 */
public record RegionMeasurement(double rateEps, double onShare, double frequencyHz, long spanUs) {
  /** Result without events. */
  public static final RegionMeasurement NOTHING =
      new RegionMeasurement(0, Double.NaN, Double.NaN, 0);
}
