package haltere.ui.viewer.session;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.filters.DefaultChain;
import haltere.ui.plot.PlotField;
import java.util.List;
import java.util.function.Function;

/** Default filters, plots and speed of a source. */
public enum InitialView {
  /** Unfiltered events, for a recording or a camera. */
  RAW(DefaultChain::create, List.of()),
  /** Objects are tracked, for scenes of moving objects. */
  OBJECTS(DefaultChain::create, List.of()),
  /** Wings are tracked and plotted, for a tethered fly. */
  FLY(
      DefaultChain::forFly,
      List.of(
          new PlotField("wing-tracker", "wings", "angle_rad"),
          new PlotField("wing-tracker", "wings", "frequency_hz")));

  private final Function<SensorGeometry, FilterChain> usual;
  private final List<PlotField> plots;

  InitialView(Function<SensorGeometry, FilterChain> usual, List<PlotField> plots) {
    this.usual = usual;
    this.plots = plots;
  }

  /** A new initial chain. */
  FilterChain chain(SensorGeometry geometry) {
    return this == RAW ? new FilterChain(geometry) : defaultChain(geometry);
  }

  /** A new default chain for sources of this kind. */
  public FilterChain defaultChain(SensorGeometry geometry) {
    return usual.apply(geometry);
  }

  /** Initial plots; empty if plots are hidden at first. */
  public List<PlotField> plots() {
    return plots;
  }

  /** Whether a chain is still the initial one. */
  public boolean isUnchanged(FilterChain chain) {
    try (FilterChain fresh = chain(chain.geometry())) {
      return ChainFile.write(fresh).equals(ChainFile.write(chain));
    }
  }

  /** Whether a chain has the tracker that ends the first one, switched on. */
  boolean isCoveredBy(FilterChain chain) {
    try (FilterChain fresh = chain(chain.geometry())) {
      List<ChainStage> stages = fresh.stages();
      return stages.isEmpty()
          || chain.stages().stream()
              .anyMatch(
                  stage ->
                      stage.kind().equals(stages.get(stages.size() - 1).kind())
                          && stage.isEnabled());
    }
  }
}
