package haltere.ui.space;

import haltere.core.event.EventPacket;
import haltere.core.playback.Playable;
import haltere.core.playback.SliceSink;
import haltere.core.sink.Mailbox;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.orientation.BodyLineSettings;
import haltere.filters.orientation.BodyLineTracker;
import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.LiveOrientation;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * The flight of a body while a {@link CameraRig} plays: takes the events of the first camera from a
 * player, pulls those of the others along to the same time, follows the body's line in each and
 * hands over the last part of its way at the end of each slice.
 *
 * <p>Thread rule: the player's processing thread; {@link #latest} on another.
 */
public final class LiveFlight implements SliceSink {
  private static final long WAIT_US = 50_000;

  /** How far before a time the other cameras begin when the player goes back to it. */
  private static final long RUN_UP_US = 50_000;

  /** Moments that are shown. */
  private static final int MOST_MOMENTS = 400;

  private final CameraRig rig;
  private final LiveOrientation orientation;
  private final List<BodyLineTracker> trackers = new ArrayList<>();
  private final List<Pull> pulls = new ArrayList<>();
  private final Deque<BodyFlight.Moment> moments = new ArrayDeque<>();
  private final Mailbox<BodyFlight> latest = new Mailbox<>();
  private long playedUs = Long.MIN_VALUE;
  private boolean changed;

  /**
   * Nothing has been seen yet.
   *
   * @param rig the cameras
   */
  public LiveFlight(CameraRig rig) {
    this.rig = rig;
    orientation =
        new LiveOrientation(rig.cameras(), OrientationSettings.defaults(), WAIT_US, this::oriented);
    addTracker(rig.first());
    for (Playable other : rig.others()) {
      pulls.add(new Pull(other, addTracker(other), trackers.size() - 1));
    }
  }

  private BodyLineTracker addTracker(Playable of) {
    int camera = trackers.size();
    BodyLineTracker tracker =
        new BodyLineTracker(
            of.geometry(), BodyLineSettings.defaults(), line -> orientation.line(camera, line));
    trackers.add(tracker);
    return tracker;
  }

  private void oriented(OrientationEstimate now, BodyOrientationEstimator body) {
    List<Double> residuals = new ArrayList<>();
    List<Boolean> used = new ArrayList<>();
    for (int i = 0; i < trackers.size(); i++) {
      residuals.add(Math.toDegrees(body.residualRad(i)));
      used.add(body.used(i));
    }
    if (moments.size() == MOST_MOMENTS) {
      moments.removeFirst();
    }
    moments.addLast(new BodyFlight.Moment(now, residuals, used));
    changed = true;
  }

  @Override
  public void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    if (packet.firstTimeUs() < playedUs) {
      forget();
      long fromUs = packet.firstTimeUs();
      pulls.forEach(pull -> pull.goBack(fromUs));
    }
    trackers.get(0).track(packet);
    playedUs = packet.lastTimeUs();
    for (Pull pull : pulls) {
      pull.to(playedUs);
    }
    orientation.reached(0, playedUs);
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.endsContinuity()) {
      forget();
    }
  }

  private void forget() {
    orientation.reset();
    trackers.forEach(BodyLineTracker::reset);
    moments.clear();
    changed = true;
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    if (changed) {
      changed = false;
      latest.put(new BodyFlight(rig.cameras(), List.copyOf(moments)));
    }
  }

  /**
   * What there is to show.
   *
   * @return the last part of the flight, or null if it is the same as before
   */
  public BodyFlight latest() {
    return latest.poll();
  }

  /** One of the other cameras. */
  private final class Pull implements StreamHandler {
    private final Playable source;
    private final BodyLineTracker tracker;
    private final int camera;
    private long reachedUs = Long.MIN_VALUE;
    private boolean ended;

    Pull(Playable source, BodyLineTracker tracker, int camera) {
      this.source = source;
      this.tracker = tracker;
      this.camera = camera;
    }

    /** Goes on to a time; a source that cannot be read any more has ended. */
    void to(long timeUs) {
      try {
        while (reachedUs < timeUs && !ended) {
          ended = !source.next(this);
        }
      } catch (IOException unreadable) {
        ended = true;
      }
      orientation.reached(camera, ended ? timeUs : Math.min(reachedUs, timeUs));
    }

    /** Goes back to before a time; to the start where there is no other place to go to. */
    void goBack(long timeUs) {
      reachedUs = Long.MIN_VALUE;
      long elapsedUs = source.elapsedUs(timeUs) - RUN_UP_US;
      try {
        source.seek(source.seekable() ? Math.max(0, elapsedUs) : 0);
        ended = false;
      } catch (IOException unreadable) {
        ended = true;
      }
    }

    @Override
    public void packet(EventPacket packet) {
      if (!packet.isEmpty()) {
        tracker.track(packet);
        reachedUs = packet.lastTimeUs();
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification.endsContinuity()) {
        tracker.reset();
      }
    }
  }
}
