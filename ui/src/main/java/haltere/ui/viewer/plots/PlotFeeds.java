package haltere.ui.viewer.plots;

import haltere.core.chain.FilterChain;
import haltere.ui.plot.InertialFeed;
import haltere.ui.plot.Lane;
import haltere.ui.plot.PlotFeed;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.SampleQueue;
import haltere.ui.viewer.chain.ChainEditor;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Subscriptions of the plots to the open chain, renewed after each change of the chain or the
 * lanes.
 */
final class PlotFeeds {
  /** The fields of a chain, and the subscriptions. */
  private record Opened(List<PlotField> offered, List<PlotFeed> feeds) {}

  /** Difference to the newest sample above which an older one starts a run-up, microseconds. */
  private static final long MAX_DISORDER_US = 100_000;

  private final ChainEditor editor;
  private final Consumer<List<PlotField>> offered;
  private List<PlotFeed> feeds = List.of();
  private InertialFeed inertial = new InertialFeed();
  private int changes;

  /** Without subscriptions; the consumer gets the plottable fields after changes. */
  PlotFeeds(ChainEditor editor, Consumer<List<PlotField>> offered) {
    this.editor = editor;
    this.offered = offered;
  }

  /** Sets the inertial samples of another recording. */
  void setInertial(InertialFeed newInertial) {
    inertial = newInertial;
  }

  /** Whether there are inertial samples. */
  boolean hasInertial() {
    return inertial.hasSamples();
  }

  /** Subscribes to the fields of some lanes. */
  void follow(List<Lane> lanes) {
    int change = ++changes;
    close();
    Set<PlotField> wanted = new LinkedHashSet<>();
    lanes.forEach(lane -> wanted.addAll(lane.fields()));
    editor.read(chain -> open(wanted, chain), opened -> take(change, opened));
  }

  /** On the processing thread. */
  private static Opened open(Set<PlotField> wanted, FilterChain chain) {
    List<PlotFeed> opened = new ArrayList<>();
    wanted.forEach(field -> PlotFeed.open(field, chain).ifPresent(opened::add));
    return new Opened(PlotField.of(chain), opened);
  }

  private void take(int change, Opened opened) {
    if (change == changes) {
      feeds = opened.feeds();
      offered.accept(opened.offered());
    } else {
      opened.feeds().forEach(PlotFeed::close);
    }
  }

  /** Passes new samples to their lanes; true if there were any. */
  boolean drainTo(List<Lane> lanes) {
    boolean[] any = new boolean[1];
    feeds.forEach(feed -> feed.queue().drainTo(consumer(feed.field(), lanes, any)));
    for (PlotField field : InertialFeed.FIELDS) {
      inertial.drainTo(field, consumer(field, lanes, any));
    }
    return any[0];
  }

  /** Passes samples to the lanes of their field; others are dropped. */
  private static SampleQueue.SampleConsumer consumer(
      PlotField field, List<Lane> lanes, boolean[] any) {
    List<Lane> consumers = lanes.stream().filter(lane -> lane.has(field)).toList();
    return (timeUs, key, value) -> {
      for (Lane lane : consumers) {
        any[0] = true;
        if (timeUs < lane.lastUs(field) - MAX_DISORDER_US) {
          // earlier tracks would remain beside those found after the reset
          lane.removeFrom(timeUs);
        }
        lane.take(field, timeUs, key, value);
      }
    };
  }

  /** Number of samples that came too fast to be plotted. */
  long lost() {
    return feeds.stream().mapToLong(feed -> feed.queue().lost()).sum();
  }

  void close() {
    feeds.forEach(PlotFeed::close);
    feeds = List.of();
  }
}
