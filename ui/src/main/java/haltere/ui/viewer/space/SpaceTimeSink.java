package haltere.ui.viewer.space;

import haltere.core.event.EventPacket;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.rendering.FrameExchange;
import haltere.ui.rendering.SpaceTimeCloud;
import haltere.ui.rendering.SpaceTimeView;

/**
 * Gathers the newest events for the view in space and time and hands over a copy whenever the last
 * one has been fetched.
 *
 * <p>Thread rule: {@link #setSpan} and fetching on the JavaFX thread, the rest on the processing
 * thread.
 */
final class SpaceTimeSink implements SliceSink {
  /** Events that are shown at most. */
  static final int MOST = 150_000;

  private final SpaceTimeCloud cloud = new SpaceTimeCloud(MOST);
  private final FrameExchange<SpaceTimeCloud.Points> exchange =
      new FrameExchange<>(() -> new SpaceTimeCloud.Points(MOST));
  private volatile long spanUs = SpaceTimeView.DEFAULT.spanUs();

  /** How far back events are shown. */
  void setSpan(long newSpanUs) {
    spanUs = newSpanUs;
  }

  FrameExchange<SpaceTimeCloud.Points> exchange() {
    return exchange;
  }

  @Override
  public void packet(EventPacket packet) {
    cloud.packet(packet);
  }

  @Override
  public void notified(StreamNotification notification) {
    cloud.notified(notification);
  }

  @Override
  public long memoryUs(long sliceUs) {
    return spanUs;
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    cloud.advanceTo(toUs);
    if (!exchange.isPending()) {
      sliceHeld();
    }
  }

  @Override
  public void sliceHeld() {
    cloud.copyTo(spanUs, exchange.back());
    exchange.publish();
  }
}
