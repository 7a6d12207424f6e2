package haltere.core.sink;

import java.util.List;
import java.util.Optional;

/**
 * The unit of a column, which is the suffix of its name.
 *
 * @param suffix of the name, such as {@code _px_s}
 * @param symbol for users, such as px/s
 * @since 0.1
 */
public record ColumnUnit(String suffix, String symbol) {
  /** The longer ones first. */
  private static final List<ColumnUnit> ALL =
      List.of(
          new ColumnUnit("_rad2_per_s2", "rad\u00b2/s\u00b2"),
          new ColumnUnit("_rad2_per_s", "rad\u00b2/s"),
          new ColumnUnit("_rad2", "rad\u00b2"),
          new ColumnUnit("_rad_s", "rad/s"),
          new ColumnUnit("_rad", "rad"),
          new ColumnUnit("_px_s", "px/s"),
          new ColumnUnit("_px", "px"),
          new ColumnUnit("_m_s", "m/s"),
          new ColumnUnit("_km_h", "km/h"),
          new ColumnUnit("_m", "m"),
          new ColumnUnit("_hz", "Hz"),
          new ColumnUnit("_us", "\u00b5s"),
          new ColumnUnit("_eps", "ev/s"),
          new ColumnUnit("_deg_s", "\u00b0/s"),
          new ColumnUnit("_g", "g"),
          new ColumnUnit("_c", "\u00b0C"),
          new ColumnUnit("_s", "s"));

  /**
   * The unit of a column.
   *
   * @param column its name
   * @return empty if the name has none
   */
  public static Optional<ColumnUnit> of(String column) {
    return ALL.stream().filter(unit -> column.endsWith(unit.suffix())).findFirst();
  }
}
