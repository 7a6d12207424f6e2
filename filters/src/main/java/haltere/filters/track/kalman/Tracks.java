package haltere.filters.track.kalman;

import haltere.filters.track.MeasurementSettings;
import haltere.filters.track.motion.MotionNoise;
import java.util.Arrays;

/** The tracks that there are, in the order of their births. Thread rule: that of its owner. */
final class Tracks {
  private final TrackListener listener;
  private MotionNoise noise;
  private MeasurementPlane plane;
  private MeasurementSettings measurement;
  private Comparison compared;

  /** Behind those that there are: ended ones, to be used again. */
  private Track[] tracks = new Track[0];

  private int count;
  private int lastId;
  private int lastSerial;

  Tracks(TrackListener listener) {
    this.listener = listener;
  }

  /** Says how tracks that are made from now on move and measure. */
  void setModel(
      MotionNoise newNoise, MeasurementPlane newPlane, MeasurementSettings newMeasurement) {
    noise = newNoise;
    plane = newPlane;
    measurement = newMeasurement;
    compared = new Comparison(noise);
  }

  /** Changes how many there may be, which is no less than there are. */
  void setMost(int most) {
    tracks = Arrays.copyOf(tracks, most);
  }

  /** An identity that was never given out before. */
  int nextId() {
    return ++lastId;
  }

  int count() {
    return count;
  }

  boolean isFull() {
    return count == tracks.length;
  }

  Track get(int index) {
    return tracks[index];
  }

  /** One more, to be launched. */
  Track add() {
    Track track = tracks[count];
    if (track == null) {
      track = new Track(noise, plane, measurement, compared);
      tracks[count] = track;
    }
    count++;
    track.serial = ++lastSerial;
    return track;
  }

  void drop(Track track) {
    int index = 0;
    while (tracks[index] != track) {
      index++;
    }
    drop(index);
  }

  void drop(int index) {
    Track gone = tracks[index];
    gone.release(false);
    System.arraycopy(tracks, index + 1, tracks, index, count - index - 1);
    tracks[--count] = gone;
    if (gone.id > 0) {
      listener.ended(gone.id);
    }
  }

  /** Ends the identity of a track that goes on without one. */
  void end(Track track) {
    listener.ended(track.id);
    track.id = 0;
  }

  void dropAll() {
    while (count > 0) {
      drop(count - 1);
    }
  }

  /** Ends all, none of which is used again. */
  void discardAll() {
    dropAll();
    Arrays.fill(tracks, null);
  }
}
