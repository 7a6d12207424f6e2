package haltere.filters.cluster;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventPackets;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** A cluster tracker with the rows that it has reported; the mass is the support of clusters. */
final class ClusterRun {
  static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  final List<ClusterTrack> rows = new ArrayList<>();
  final ClusterTracker tracker;

  ClusterRun(String... changes) {
    this(SENSOR, changes);
  }

  ClusterRun(SensorGeometry sensor, String... changes) {
    tracker =
        new ClusterTracker(
            sensor,
            ClusterTrackerSettings.defaults().with("life.supportedBy=mass").with(changes),
            new ClusterListener() {
              @Override
              public void reported(long timeUs) {
                report(timeUs);
              }
            });
  }

  private void report(long timeUs) {
    rows.addAll(tracker.tracks(timeUs));
  }

  /** Takes a copy of events. */
  ClusterRun take(EventPacket events) {
    tracker.track(EventPackets.copy(events));
    return this;
  }

  Set<Integer> identities() {
    return rows.stream().map(ClusterTrack::id).collect(Collectors.toSet());
  }

  ClusterTrack last() {
    return rows.get(rows.size() - 1);
  }

  List<ClusterTrack> at(long timeUs) {
    return rows.stream().filter(row -> row.timeUs() == timeUs).toList();
  }

  List<ClusterTrack> after(long timeUs) {
    return rows.stream().filter(row -> row.timeUs() > timeUs).toList();
  }

  /** Events of two packets in the order of their times. */
  static EventPacket merged(EventPacket first, EventPacket second) {
    EventPacket merged = new EventPacket(first.size() + second.size());
    int i = 0;
    int j = 0;
    while (i < first.size() || j < second.size()) {
      boolean takeFirst =
          j == second.size() || (i < first.size() && first.timeUs(i) <= second.timeUs(j));
      EventPacket from = takeFirst ? first : second;
      int index = takeFirst ? i++ : j++;
      merged.append(from.timeUs(index), from.address(index));
    }
    return merged;
  }

  /** An event each so many microseconds at a pixel. */
  static EventPacket pixel(int x, int y, long fromUs, long toUs, long stepUs) {
    EventPacket events = new EventPacket(0);
    for (long timeUs = fromUs; timeUs < toUs; timeUs += stepUs) {
      events.append(timeUs, x, y, true);
    }
    return events;
  }
}
