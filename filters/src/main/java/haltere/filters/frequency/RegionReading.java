package haltere.filters.frequency;

/**
 * What a region has been doing lately.
 *
 * @param rateEps events per second of recording time
 * @param onShare share of ON events in them, 0 to 1; NaN without events
 * @param frequencyHz frequency with which the events come and go; NaN if nothing repeats
 * @param spanUs recording time that the numbers rest on
 * @since 0.1
 */
public record RegionReading(double rateEps, double onShare, double frequencyHz, long spanUs) {
  /** Of a region that has seen nothing. */
  public static final RegionReading NOTHING = new RegionReading(0, Double.NaN, Double.NaN, 0);
}
