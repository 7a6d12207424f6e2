package haltere.ui.command;

import haltere.filters.object.ObjectTrack;
import haltere.filters.object.ObjectTrackerFilter;
import java.util.Comparator;
import java.util.PriorityQueue;
import java.util.function.Consumer;

/**
 * Rows of objects in the order of their times. When an identity is decided its rows come at once;
 * they are older than rows that have come by at most {@link ObjectTrackerFilter#UNDECIDED_S}.
 */
final class OrderedTracks implements Consumer<ObjectTrack> {
  private static final long HOLD_US = Math.round(ObjectTrackerFilter.UNDECIDED_S * 1e6);

  private final PriorityQueue<ObjectTrack> held =
      new PriorityQueue<>(
          Comparator.comparingLong(ObjectTrack::timeUs).thenComparingInt(ObjectTrack::id));
  private final Consumer<? super ObjectTrack> next;
  private long lastUs = Long.MIN_VALUE;

  OrderedTracks(Consumer<? super ObjectTrack> next) {
    this.next = next;
  }

  @Override
  public void accept(ObjectTrack track) {
    boolean isAnew = track.timeUs() < lastUs - HOLD_US;
    if (isAnew) {
      // the recording's clock began anew
      finish();
    }
    lastUs = isAnew ? track.timeUs() : Math.max(lastUs, track.timeUs());
    held.add(track);
    while (held.peek().timeUs() < lastUs - HOLD_US) {
      next.accept(held.remove());
    }
  }

  /** Hands on what is held. */
  void finish() {
    while (!held.isEmpty()) {
      next.accept(held.remove());
    }
  }
}
