package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.ArrayList;
import java.util.List;

/** Writes down what a sink is told, with the events of a slice on one line. */
final class SliceLog implements SliceSink {
  final List<String> lines = new ArrayList<>();
  final List<Long> times = new ArrayList<>();
  long slices;
  long events;
  boolean quiet;
  private final List<Long> slice = new ArrayList<>();
  private boolean runUp;
  private final StreamGrammar grammar =
      new StreamGrammar(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              take(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              note(notification);
            }
          });

  @Override
  public void packet(EventPacket packet) {
    grammar.packet(packet);
  }

  @Override
  public void notified(StreamNotification notification) {
    grammar.notified(notification);
  }

  private void take(EventPacket packet) {
    events += runUp ? 0 : packet.size();
    for (int i = 0; !quiet && i < packet.size(); i++) {
      times.add(packet.timeUs(i));
      slice.add(packet.timeUs(i));
    }
  }

  private void note(StreamNotification notification) {
    if (!slice.isEmpty()) {
      lines.add("in the middle of " + slice);
    }
    if (notification instanceof Reset reset) {
      lines.add("Reset " + reset.cause());
    } else if (notification instanceof DataLost lost) {
      lines.add("DataLost " + lost.estimatedEvents());
    } else {
      lines.add(notification.getClass().getSimpleName());
    }
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    slices++;
    if (quiet) {
      return;
    }
    for (long timeUs : slice) {
      if (timeUs < fromUs || timeUs >= toUs) {
        throw new AssertionError(timeUs + " us is not in [" + fromUs + ", " + toUs + ")");
      }
    }
    lines.add("[" + fromUs + "," + toUs + ") " + slice);
    slice.clear();
  }

  @Override
  public void runUpBegins(long sliceUs) {
    runUp = true;
  }

  @Override
  public void runUpEnds() {
    runUp = false;
    if (!slice.isEmpty()) {
      lines.add("run-up " + slice);
      slice.clear();
    }
  }

  /** The log since the last call. */
  List<String> take() {
    List<String> taken = List.copyOf(lines);
    lines.clear();
    return taken;
  }
}
