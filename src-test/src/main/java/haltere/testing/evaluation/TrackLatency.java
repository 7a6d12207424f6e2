package haltere.testing.evaluation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * How long it takes until an object has a track.
 *
 * @param latenciesUs of each object that got one, ascending, microseconds
 * @param never objects that never got one
 */
public record TrackLatency(List<Long> latenciesUs, int never) {
  /** Copies the list. */
  public TrackLatency {
    latenciesUs = latenciesUs.stream().sorted().toList();
  }

  /**
   * Latencies from the first row of truth of each object.
   *
   * @param frames truth and tracks
   * @param correspondences which stands for which in these frames
   * @return the latencies
   */
  public static TrackLatency of(Frames frames, Correspondences correspondences) {
    return of(frames, correspondences, Map.of());
  }

  /**
   * Latencies from the first event of each object.
   *
   * @param frames truth and tracks
   * @param correspondences which stands for which in these frames
   * @param firstEventUs time of the first event by identity of the true object; one that is not
   *     there counts from its first row of truth
   * @return the latencies
   */
  public static TrackLatency of(
      Frames frames, Correspondences correspondences, Map<Integer, Long> firstEventUs) {
    Map<Integer, Long> starts = new TreeMap<>();
    for (Frame frame : frames.list()) {
      for (ObjectPoint truth : frame.truth()) {
        starts.putIfAbsent(truth.id(), firstEventUs.getOrDefault(truth.id(), truth.timeUs()));
      }
    }
    int objects = starts.size();
    List<Long> latencies = new ArrayList<>();
    for (Match match : correspondences.matches()) {
      Long start = starts.remove(match.truth().id());
      if (start != null) {
        latencies.add(match.truth().timeUs() - start);
      }
    }
    return new TrackLatency(latencies, objects - latencies.size());
  }

  /**
   * Mean latency.
   *
   * @return microseconds, NaN if no object got a track
   */
  public double meanUs() {
    return latenciesUs.stream().mapToLong(Long::longValue).average().orElse(Double.NaN);
  }

  /**
   * Median latency, objects that never got a track counted as infinitely late.
   *
   * @return microseconds, infinite if half of the objects or more never got a track, NaN without
   *     objects
   */
  public double medianUs() {
    int objects = latenciesUs.size() + never;
    if (objects == 0) {
      return Double.NaN;
    }
    return (rank((objects - 1) / 2) + rank(objects / 2)) / 2;
  }

  /**
   * Greatest latency.
   *
   * @return microseconds, infinite if an object never got a track, NaN without objects
   */
  public double greatestUs() {
    int objects = latenciesUs.size() + never;
    return objects == 0 ? Double.NaN : rank(objects - 1);
  }

  private double rank(int rank) {
    return rank < latenciesUs.size() ? latenciesUs.get(rank) : Double.POSITIVE_INFINITY;
  }
}
