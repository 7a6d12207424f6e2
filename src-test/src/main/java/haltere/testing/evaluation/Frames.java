package haltere.testing.evaluation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * Rows of truth and of tracks, laid side by side at their times. Immutable.
 *
 * <p>Truth and tracks have to be sampled at the same times: a truth row without track rows at its
 * time is an object that was missed.
 */
public final class Frames {
  private final List<Frame> frames;
  private final int[] truthIds;
  private final int[] trackIds;

  private final ToDoubleBiFunction<ObjectPoint, ObjectPoint> distance;

  private Frames(List<Frame> frames, ToDoubleBiFunction<ObjectPoint, ObjectPoint> distance) {
    this.frames = List.copyOf(frames);
    this.distance = distance;
    truthIds = ids(Frame::truth);
    trackIds = ids(Frame::tracks);
  }

  /**
   * Lays rows side by side at all times that any of them has.
   *
   * @param truth in any order
   * @param tracks in any order
   * @return a frame for each time, in order
   * @throws IllegalArgumentException if an identity is at two places at one time
   */
  public static Frames of(Collection<ObjectPoint> truth, Collection<ObjectPoint> tracks) {
    return at(
        Stream.concat(truth.stream(), tracks.stream())
            .mapToLong(ObjectPoint::timeUs)
            .distinct()
            .toArray(),
        truth,
        tracks);
  }

  /**
   * Lays rows side by side at stated times.
   *
   * @param timesUs the times at which both were sampled, whether there was anything then or not
   * @param truth in any order
   * @param tracks in any order
   * @return a frame for each time, in order
   * @throws IllegalArgumentException if an identity is at two places at one time, or a row is of
   *     another time
   */
  public static Frames at(
      long[] timesUs, Collection<ObjectPoint> truth, Collection<ObjectPoint> tracks) {
    Map<Long, TreeMap<Integer, ObjectPoint>> truthAt = byTime(timesUs, truth, "truth");
    Map<Long, TreeMap<Integer, ObjectPoint>> tracksAt = byTime(timesUs, tracks, "tracks");
    List<Frame> frames = new ArrayList<>();
    truthAt.forEach(
        (time, points) ->
            frames.add(
                new Frame(
                    time, List.copyOf(points.values()), List.copyOf(tracksAt.get(time).values()))));
    return new Frames(frames, ObjectPoint::distanceTo);
  }

  /**
   * Several scenes joined one after the other, with separate identities: a metric of the whole
   * weights each scene by its content.
   *
   * @param scenes at least none
   * @return their frames; times and identities are new ones
   */
  public static Frames joined(List<Frames> scenes) {
    List<Frame> frames = new ArrayList<>();
    long startUs = 0;
    int truthBase = 0;
    int trackBase = 0;
    for (Frames scene : scenes) {
      long lastUs = startUs;
      for (Frame frame : scene.frames) {
        long timeUs = startUs + (frame.timeUs() - scene.frames.get(0).timeUs());
        frames.add(
            new Frame(
                timeUs,
                moved(frame.truth(), timeUs, scene.truthIds, truthBase),
                moved(frame.tracks(), timeUs, scene.trackIds, trackBase)));
        lastUs = timeUs;
      }
      startUs = lastUs + 1;
      truthBase += scene.truthIds.length;
      trackBase += scene.trackIds.length;
    }
    return new Frames(frames, ObjectPoint::distanceTo);
  }

  /**
   * The same frames with another distance of truth and track, such as one in units of the object's
   * size. Scores take their gates in its unit.
   *
   * @param truthToTrack distance of a point of truth and the point of a track of its frame, at
   *     least 0
   * @return new frames; what is joined of them has the Euclidean distance again
   */
  public Frames measuredBy(ToDoubleBiFunction<ObjectPoint, ObjectPoint> truthToTrack) {
    return new Frames(frames, truthToTrack);
  }

  /** Distance of a point of truth and the point of a track. */
  double distance(ObjectPoint truth, ObjectPoint track) {
    return distance.applyAsDouble(truth, track);
  }

  /**
   * All frames.
   *
   * @return in the order of time
   */
  public List<Frame> list() {
    return frames;
  }

  /**
   * How many true objects there are.
   *
   * @return identities, whenever they appear
   */
  public int truthCount() {
    return truthIds.length;
  }

  /**
   * How many tracks there are.
   *
   * @return identities, whenever they appear
   */
  public int trackCount() {
    return trackIds.length;
  }

  /** Place of a true object among all, from 0. */
  int truthIndex(ObjectPoint point) {
    return Arrays.binarySearch(truthIds, point.id());
  }

  /** Place of a track among all, from 0. */
  int trackIndex(ObjectPoint point) {
    return Arrays.binarySearch(trackIds, point.id());
  }

  /** Points of each true object, by its index. */
  int[] truthPoints() {
    int[] counts = new int[truthIds.length];
    frames.forEach(frame -> frame.truth().forEach(point -> counts[truthIndex(point)]++));
    return counts;
  }

  /** Points of each track, by its index. */
  int[] trackPoints() {
    int[] counts = new int[trackIds.length];
    frames.forEach(frame -> frame.tracks().forEach(point -> counts[trackIndex(point)]++));
    return counts;
  }

  /** The most true objects in a frame. */
  int mostTruth() {
    return frames.stream().mapToInt(frame -> frame.truth().size()).max().orElse(0);
  }

  /** The most tracks in a frame. */
  int mostTracks() {
    return frames.stream().mapToInt(frame -> frame.tracks().size()).max().orElse(0);
  }

  private int[] ids(Function<Frame, List<ObjectPoint>> points) {
    return frames.stream()
        .flatMap(frame -> points.apply(frame).stream())
        .mapToInt(ObjectPoint::id)
        .distinct()
        .sorted()
        .toArray();
  }

  private static Map<Long, TreeMap<Integer, ObjectPoint>> byTime(
      long[] timesUs, Collection<ObjectPoint> points, String what) {
    Map<Long, TreeMap<Integer, ObjectPoint>> byTime = new TreeMap<>();
    LongStream.of(timesUs).forEach(time -> byTime.put(time, new TreeMap<>()));
    for (ObjectPoint point : points) {
      TreeMap<Integer, ObjectPoint> at = byTime.get(point.timeUs());
      if (at == null) {
        throw new IllegalArgumentException(
            "there are " + what + " at " + point.timeUs() + " us, which is none of the times");
      }
      if (at.put(point.id(), point) != null) {
        throw new IllegalArgumentException(
            what + " have " + point.id() + " twice at " + point.timeUs() + " us");
      }
    }
    return byTime;
  }

  private static List<ObjectPoint> moved(
      List<ObjectPoint> points, long timeUs, int[] ids, int base) {
    return points.stream()
        .map(
            p ->
                new ObjectPoint(
                    timeUs, base + Arrays.binarySearch(ids, p.id()), p.x(), p.y(), p.vx(), p.vy()))
        .toList();
  }
}
