package haltere.filters;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import java.util.List;

/** The chain that a new user starts with. */
public final class DefaultChain {
  private static final List<String> FILTERS =
      List.of("background-activity", "hot-pixels", "cluster-tracker");

  private DefaultChain() {}

  /**
   * Noise filters first, then the tracker, all with their default settings.
   *
   * @param geometry the sensor whose events it will see
   * @return a new chain
   */
  public static FilterChain create(SensorGeometry geometry) {
    FilterChain chain = new FilterChain(geometry);
    FILTERS.forEach(name -> chain.add(Filters.named(name)));
    return chain;
  }
}
