package haltere.ui.viewer.session;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.filters.DefaultChain;
import haltere.ui.plot.PlotField;
import java.util.List;
import java.util.function.Function;

/** The filters and plots that a user gets who has not chosen any. */
public enum FirstView {
  /** For what is not known. */
  USUAL(DefaultChain::create, List.of()),
  /** For a tethered fly. */
  FLY(
      DefaultChain::forFly,
      List.of(
          new PlotField("wing-tracker", "wings", "angle_rad"),
          new PlotField("wing-tracker", "wings", "frequency_hz")));

  private final Function<SensorGeometry, FilterChain> maker;
  private final List<PlotField> plots;

  FirstView(Function<SensorGeometry, FilterChain> maker, List<PlotField> plots) {
    this.maker = maker;
    this.plots = plots;
  }

  /** A new chain for a sensor. */
  FilterChain chain(SensorGeometry geometry) {
    return maker.apply(geometry);
  }

  /** What is plotted at first; nothing where plots are hidden at first. */
  public List<PlotField> plots() {
    return plots;
  }

  /** Whether nobody has changed a chain that began as this one. */
  public boolean isUnchanged(FilterChain chain) {
    FilterChain fresh = chain(chain.geometry());
    try {
      return ChainFile.write(fresh).equals(ChainFile.write(chain));
    } finally {
      fresh.close();
    }
  }
}
