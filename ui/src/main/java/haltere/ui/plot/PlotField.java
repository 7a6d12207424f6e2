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
 * A published number over time. Its name identifies it in other chains too.
 *
 * @param stage name of the stage; empty for other numbers
 * @param outlet name of the outlet
 * @param column name of the column
 */
public record PlotField(String stage, String outlet, String column) {
  /** The rate of events into the chain, which is no filter's. */
  public static final PlotField EVENT_RATE = new PlotField("", "playback", "event_rate_eps");

  private static final Pattern COVARIANCE = Pattern.compile("p (v?[xy]){2}");

  /**
   * The unit of the number, by the suffix of the column's name, such as "rad", "px/s" or "\u00b5s";
   * empty without one.
   */
  public String unit() {
    return ColumnUnit.of(column).map(ColumnUnit::symbol).orElse("");
  }

  /**
   * The column as a label without its unit, such as "event rate", or "P xx" for an entry of a
   * covariance matrix.
   */
  public String label() {
    int unit = ColumnUnit.of(column).map(found -> found.suffix().length()).orElse(0);
    String name = column.substring(0, column.length() - unit).replace('_', ' ');
    return COVARIANCE.matcher(name).matches() ? "P" + name.substring(1) : name;
  }

  /** The outlet, the label and the stage, such as "objects: x (object-tracker)". */
  public String title() {
    return outlet + ": " + label() + (stage.isEmpty() ? "" : " (" + stage + ")");
  }

  /**
   * All that the filters of a chain publish and that can be plotted, in the order of the chain,
   * without {@link #EVENT_RATE}; read on its processing thread, or while it does not run.
   */
  public static List<PlotField> of(FilterChain chain) {
    List<PlotField> fields = new ArrayList<>();
    for (ChainStage stage : chain.innermostStages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        for (String column : PlotRow.of(outlet.type()).map(PlotRow::columns).orElse(List.of())) {
          fields.add(new PlotField(stage.name(), outlet.name(), column));
        }
      }
    }
    return fields;
  }

  /**
   * The outlet of a chain that publishes the number, read as by {@link #of}; empty if none does.
   */
  public Optional<Outlet<?>> find(FilterChain chain) {
    return chain.innermostStages().stream()
        .filter(candidate -> candidate.name().equals(stage))
        .flatMap(candidate -> candidate.filter().outlets().stream())
        .filter(published -> published.name().equals(outlet))
        .findFirst();
  }

  /**
   * Subscribes to the numbers of a chain, on its processing thread, with those of run-ups on
   * request; called there, or while it does not run. Empty if the chain does not publish the field.
   */
  public Optional<Outlet.Subscription> listen(
      FilterChain chain, boolean inRunUps, SampleQueue.SampleConsumer consumer) {
    return find(chain).flatMap(outlet -> listen(outlet, inRunUps, consumer));
  }

  /** Subscribes to the numbers of an outlet, as to those of a chain. */
  public Optional<Outlet.Subscription> listen(
      Outlet<?> published, boolean inRunUps, SampleQueue.SampleConsumer consumer) {
    Optional<PlotRow> type = PlotRow.of(published.type());
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
    return Optional.of(inRunUps ? published.follow(listener) : published.subscribe(listener));
  }

  /** The field as text, such as "cluster-tracker / clusters / x_px". */
  @Override
  public String toString() {
    return (stage.isEmpty() ? "" : stage + " / ") + outlet + " / " + column;
  }
}
