package haltere.ui.space;

import haltere.core.camera.ClockRelation;
import haltere.core.event.EventPacket;
import haltere.core.playback.CameraPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.orientation.LiveOrientation;
import haltere.filters.orientation.line.BodyLineSettings;
import haltere.filters.orientation.line.BodyLineTracker;
import java.io.IOException;
import java.util.Optional;

/**
 * A camera of a rig other than the first: read up to the first one's time, while the body's line is
 * tracked in its events. Later events wait. Times of a live camera are converted to the first one's
 * clock.
 *
 * <p>Thread rule: the player's processing thread.
 */
final class FollowedCamera implements StreamHandler {
  /** Time before the player's new position at which a camera starts again. */
  private static final long RUN_UP_US = 50_000;

  private final Playable source;
  private final Playable first;
  private final int number;
  private final LiveOrientation orientation;
  private final Optional<SliceSink> picture;
  private final BodyLineTracker tracker;
  private final EventPacket waiting = new EventPacket(1024);
  private final EventPacket part = new EventPacket(1024);
  private int given;
  private long lastUs = Long.MIN_VALUE;
  private boolean ended;

  /**
   * Nothing has been pulled yet of a camera of the rig, counted from 1; its lines go to the
   * orientation, its events to the picture.
   */
  FollowedCamera(
      CameraRig rig, int number, LiveOrientation orientation, Optional<SliceSink> picture) {
    this.picture = picture;
    this.source = rig.others().get(number - 1);
    this.first = rig.first();
    this.number = number;
    this.orientation = orientation;
    tracker =
        new BodyLineTracker(
            source.geometry(), BodyLineSettings.defaults(), line -> orientation.line(number, line));
  }

  /** Goes on to a time; a source that cannot be read any more has ended. */
  void to(long timeUs) {
    try {
      deliverUntil(timeUs);
      while (given == waiting.size()
          && !ended
          && (!(source instanceof CameraPlayable live) || live.camera().await(0))) {
        ended = !source.next(this);
        deliverUntil(timeUs);
      }
    } catch (IOException unreadable) {
      ended = true;
    }
    boolean isComplete = ended || given < waiting.size();
    orientation.reached(number, isComplete ? timeUs : Math.min(lastUs, timeUs));
  }

  private void deliverUntil(long untilUs) {
    int to = waiting.indexAtOrAfter(untilUs + 1, given);
    if (to > given) {
      part.clear();
      part.append(waiting, given, to);
      given = to;
      tracker.track(part);
      picture.ifPresent(each -> each.packet(part));
    }
  }

  /** Seeks to before a time; to the start if that is impossible; a live camera does not seek. */
  void goBack(long timeUs) {
    if (source.isLive()) {
      return;
    }
    clear();
    long elapsedUs = source.elapsedUs(timeUs) - RUN_UP_US;
    try {
      source.seek(source.seekable() && elapsedUs >= source.earliestUs() ? elapsedUs : 0);
      ended = false;
    } catch (IOException unreadable) {
      ended = true;
    }
  }

  /** Removes the body and waiting events. */
  void clear() {
    tracker.reset();
    waiting.clear();
    given = 0;
    lastUs = Long.MIN_VALUE;
  }

  @Override
  public void packet(EventPacket packet) {
    waiting.clear();
    given = 0;
    if (packet.isEmpty()) {
      return;
    }
    if (source.isLive()) {
      takeOnFirstClock(packet);
    } else {
      waiting.append(packet, 0, packet.size());
      lastUs = packet.lastTimeUs();
    }
  }

  /** Converted times do not go back when the relation of the clocks becomes more accurate. */
  private void takeOnFirstClock(EventPacket packet) {
    Optional<ClockRelation> own = relation(source);
    Optional<ClockRelation> firsts = relation(first);
    if (own.isEmpty() || firsts.isEmpty()) {
      return;
    }
    long offsetUs = own.get().onClockOf(firsts.get(), 0);
    for (int i = 0; i < packet.size(); i++) {
      lastUs = Math.max(lastUs, packet.timeUs(i) + offsetUs);
      waiting.append(lastUs, packet.address(i));
    }
  }

  private static Optional<ClockRelation> relation(Playable of) {
    return of instanceof CameraPlayable live ? live.camera().clockRelation() : Optional.empty();
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.endsContinuity()) {
      tracker.reset();
      lastUs = Long.MIN_VALUE;
    }
  }
}
