package haltere.ui.space;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.playback.SliceSink;
import haltere.core.sink.Mailbox;
import haltere.core.stream.StreamNotification;
import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.LiveOrientation;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.line.BodyLineSettings;
import haltere.filters.orientation.line.BodyLineTracker;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * The flight of a body during playback of a {@link CameraRig}: processes the first camera's events,
 * reads the others up to the same time, tracks the body's line in each, and publishes the recent
 * path at the end of each slice.
 *
 * <p>Thread rule: the player's processing thread; {@link #latest} on another.
 */
public final class LiveFlight implements SliceSink {
  private static final long WAIT_US = 50_000;
  private static final long STEP_US = 10_000;

  private static final int MAX_MOMENTS = 400;

  private final CameraRig rig;
  private final LiveOrientation orientation;
  private final BodyLineTracker tracker;
  private final List<SliceSink> pictures;
  private final List<FollowedCamera> others = new ArrayList<>();
  private final Deque<BodyFlight.Moment> moments = new ArrayDeque<>();
  private final Mailbox<BodyFlight> latest = new Mailbox<>();
  private final EventPacket step = new EventPacket(1024);
  private long playedUs = Long.MIN_VALUE;
  private boolean changed;

  /**
   * Nothing has been seen yet. The pictures take the events of each camera but the first, in order;
   * they may be fewer.
   */
  public LiveFlight(CameraRig rig, List<? extends SliceSink> pictures) {
    this.rig = rig;
    this.pictures = List.copyOf(pictures);
    orientation =
        new LiveOrientation(rig.cameras(), OrientationSettings.defaults(), WAIT_US, this::oriented);
    tracker =
        new BodyLineTracker(
            rig.first().geometry(), BodyLineSettings.defaults(), line -> orientation.line(0, line));
    for (int number = 1; number < rig.cameras().size(); number++) {
      Optional<SliceSink> picture =
          number <= pictures.size() ? Optional.of(pictures.get(number - 1)) : Optional.empty();
      others.add(new FollowedCamera(rig, number, orientation, picture));
    }
  }

  private void oriented(OrientationEstimate now, BodyOrientationEstimator body) {
    if (moments.size() == MAX_MOMENTS) {
      moments.removeFirst();
    }
    moments.addLast(BodyFlight.Moment.of(now, body, rig.cameras()));
    changed = true;
  }

  @Override
  public void packet(EventPacket packet) {
    if (!packet.isEmpty()) {
      if (packet.firstTimeUs() < playedUs) {
        clear();
        long fromUs = packet.firstTimeUs();
        others.forEach(other -> other.goBack(fromUs));
      }
      int from = 0;
      while (from < packet.size()) {
        int to = packet.indexAtOrAfter(packet.timeUs(from) + STEP_US, from);
        step.clear();
        step.append(packet, from, to);
        step(step);
        from = to;
      }
    }
  }

  /** Goes on by so little that no camera's lines have to wait for those of another. */
  private void step(EventPacket events) {
    tracker.track(events);
    playedUs = events.lastTimeUs();
    others.forEach(other -> other.to(playedUs));
    orientation.reached(0, playedUs);
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.endsContinuity()) {
      clear();
    }
    pictures.forEach(picture -> picture.notified(notification));
  }

  private void clear() {
    orientation.reset();
    tracker.reset();
    moments.clear();
    changed = true;
  }

  @Override
  public long memoryUs(long sliceUs) {
    return EventFilter.DEFAULT_MEMORY_US;
  }

  @Override
  public void sliceHeld() {
    pictures.forEach(SliceSink::sliceHeld);
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    pictures.forEach(picture -> picture.sliceEnd(fromUs, toUs));
    if (changed) {
      changed = false;
      latest.put(new BodyFlight(rig.cameras(), List.copyOf(moments)));
    }
  }

  /** The last part of the flight, or null if it is the same as before. */
  public BodyFlight latest() {
    return latest.poll();
  }
}
