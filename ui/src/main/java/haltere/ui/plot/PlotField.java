package haltere.ui.plot;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.sink.ColumnUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/**
 * A number that is published over time, by name, so that it is found again in another chain.
 *
 * @param stage name of the stage; empty for what is no filter's
 * @param outlet name of the outlet
 * @param column name of the column
 */
public record PlotField(String stage, String outlet, String column) {
  /** The rate of events into the chain, which is no filter's. */
  public static final PlotField EVENT_RATE = new PlotField("", "playback", "event_rate_eps");

  private static final Pattern COVARIANCE = Pattern.compile("p (v?[xy]){2}");

  /**
   * The unit of the number, which stands at the end of the column's name, such as "rad", "px/s" or
   * "\u00b5s"; empty where the name has none.
   */
  public String unit() {
    return ColumnUnit.of(column).map(ColumnUnit::symbol).orElse("");
  }

  /**
   * The column in words without its unit, such as "event rate", or "P xx" for a number of a
   * covariance matrix.
   */
  public String words() {
    int unit = ColumnUnit.of(column).map(found -> found.ending().length()).orElse(0);
    String name = column.substring(0, column.length() - unit).replace('_', ' ');
    return COVARIANCE.matcher(name).matches() ? "P" + name.substring(1) : name;
  }

  /**
   * All that the filters of a chain publish and that can be plotted, in the order of the chain,
   * without {@link #EVENT_RATE}; read on its processing thread, or while it does not run.
   */
  public static List<PlotField> of(FilterChain chain) {
    List<PlotField> fields = new ArrayList<>();
    for (ChainStage stage : chain.stages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        PlotRow.of(outlet.type())
            .ifPresent(
                row ->
                    row.columns()
                        .forEach(
                            column ->
                                fields.add(new PlotField(stage.name(), outlet.name(), column))));
      }
    }
    return fields;
  }

  /**
   * The outlet of a chain that publishes the number, read as by {@link #of}; empty where there is
   * none.
   */
  public Optional<Outlet<?>> find(FilterChain chain) {
    for (ChainStage candidate : chain.stages()) {
      if (candidate.name().equals(stage)) {
        for (Outlet<?> published : candidate.filter().outlets()) {
          if (published.name().equals(outlet)) {
            return Optional.of(published);
          }
        }
      }
    }
    return Optional.empty();
  }

  /**
   * Hands over the numbers that a chain publishes from now on, on its processing thread, on request
   * those of run-ups too; called there, or while it does not run. Empty where the chain does not
   * publish the field.
   */
  public Optional<Outlet.Subscription> listen(
      FilterChain chain, boolean inRunUps, SampleQueue.SampleConsumer consumer) {
    Optional<Outlet<?>> found = find(chain);
    Optional<PlotRow> type = found.flatMap(outlet -> PlotRow.of(outlet.type()));
    int at = type.map(row -> row.index(column)).orElse(-1);
    if (at < 0) {
      return Optional.empty();
    }
    PlotRow row = type.get();
    Consumer<Object> listener =
        result -> {
          Record now = (Record) result;
          consumer.take(row.timeUs(now), row.key(now), row.value(now, at));
        };
    return found.map(outlet -> inRunUps ? outlet.follow(listener) : outlet.subscribe(listener));
  }

  /** The field in words, such as "cluster-tracker / clusters / x_px". */
  @Override
  public String toString() {
    return (stage.isEmpty() ? "" : stage + " / ") + outlet + " / " + column;
  }
}
