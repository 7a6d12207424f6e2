package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;
import haltere.filters.track.EventCount;
import haltere.filters.track.MeasurementSettings;
import java.util.Arrays;

/**
 * What each cluster has gathered since its track was last updated, in the order of the readings,
 * and whether that is enough for an update. Thread rule: that of its owner.
 */
final class EventBatches {
  /** A cluster that gets too few events for so long gives what it has. */
  static final long LONGEST_US = 50_000;

  private MeasurementSettings settings;

  /** Behind those that there are: ended ones, to be used again. */
  private EventBatch[] batches = new EventBatch[0];

  private int count;
  private double eventsOfAll;

  void apply(MeasurementSettings newSettings) {
    settings = newSettings;
  }

  void clear() {
    count = 0;
    eventsOfAll = 0;
  }

  int count() {
    return count;
  }

  EventBatch get(int index) {
    return batches[index];
  }

  /** The batch of a cluster, or null. */
  EventBatch find(int clusterId) {
    for (int i = 0; i < count; i++) {
      if (batches[i].clusterId == clusterId) {
        return batches[i];
      }
    }
    return null;
  }

  /** Adds what clusters have seen; a track whose cluster is gone is without one. */
  void gather(long timeUs, ClusterReadings readings) {
    for (int i = 0; i < count; i++) {
      batches[i].seen = false;
    }
    int readingCount = readings.count();
    for (int i = 0; i < readingCount; i++) {
      EventBatch batch = of(readings.id(i), i, timeUs);
      batch.add(timeUs, readings, i);
      eventsOfAll += readings.newEvents(i);
      if (batch.track != null) {
        batch.track.events += readings.newEvents(i);
        batch.track.radiusPx = batch.radiusPx;
      }
    }
    for (int i = count - 1; i >= 0; i--) {
      if (!batches[i].seen) {
        remove(i);
      }
    }
  }

  /** The batch of a cluster, which is most often at the index of its reading. */
  private EventBatch of(int clusterId, int index, long timeUs) {
    EventBatch batch =
        index < count && batches[index].clusterId == clusterId ? batches[index] : find(clusterId);
    return batch == null ? begin(clusterId, timeUs) : batch;
  }

  private EventBatch begin(int clusterId, long timeUs) {
    if (count == batches.length) {
      batches = Arrays.copyOf(batches, count + 16);
      for (int i = count; i < batches.length; i++) {
        batches[i] = new EventBatch();
      }
    }
    EventBatch batch = batches[count++];
    batch.begin(clusterId, timeUs);
    return batch;
  }

  private void remove(int index) {
    EventBatch gone = batches[index];
    if (gone.track != null) {
      gone.track.release(gone.track.contested);
    }
    System.arraycopy(batches, index + 1, batches, index, count - index - 1);
    batches[--count] = gone;
  }

  /** Whether a batch is enough for an update of its track. */
  boolean isDue(EventBatch batch, long timeUs) {
    if (!(batch.events > 0)) {
      return false;
    }
    if (settings.eventsOf() == EventCount.ALL_CLUSTERS) {
      return areAllEnough();
    }
    return batch.events >= settings.eventsTillTrack()
        || batch.track != null && timeUs - batch.sinceUs >= LONGEST_US;
  }

  private boolean areAllEnough() {
    return eventsOfAll >= settings.eventsTillTrack();
  }

  /** Once the events of all clusters together were enough, they are counted anew. */
  void endUpdate() {
    if (areAllEnough()) {
      eventsOfAll = 0;
    }
  }
}
