package haltere.ui.viewer.space;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.rendering.FrameExchange;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.SpaceTimeCloud;
import haltere.ui.rendering.SpaceTimeView;
import java.util.List;

/**
 * Accumulates the newest events for the view in space and time, and provides a copy whenever the
 * last one has been fetched.
 *
 * <p>Thread rule: {@link #setSpan} and fetching on the JavaFX thread, the rest on the processing
 * thread.
 */
final class SpaceTimeSink implements SliceSink {
  /** The data of one picture. */
  static final class Frame {
    final SpaceTimeCloud.Points points;

    /** The time that is shown, which has the age 0, microseconds. */
    long nowUs;

    /** Marks of filters at that time. */
    List<OverlaySnapshots.Marks<?>> marks = List.of();

    /** Earlier positions of marks. */
    List<MarkTraces.Trace> traces = List.of();

    Frame(int capacity) {
      points = new SpaceTimeCloud.Points(capacity);
    }
  }

  /** Events that are shown at most. */
  static final int MAX_EVENTS = 150_000;

  /** Moments of traces in the time that is shown: ten for each of 40 wing beats. */
  private static final int MOMENTS = 400;

  private final SpaceTimeCloud cloud = new SpaceTimeCloud(MAX_EVENTS);
  private final OverlaySnapshots snapshots;
  private final MarkTraces traces = new MarkTraces();
  private final FrameExchange<Frame> exchange = new FrameExchange<>(() -> new Frame(MAX_EVENTS));
  private volatile long spanUs = SpaceTimeView.DEFAULT.spanUs();
  private List<OverlaySnapshots.Marks<?>> marks = List.of();
  private long nowUs;
  private long tracedUs;

  /** A sink that has no events yet, and shows the marks of a chain. */
  SpaceTimeSink(FilterChain chain) {
    snapshots = new OverlaySnapshots(chain);
  }

  /** Time from one position of a trace to the next, microseconds. */
  static long stepUs(long ofSpanUs) {
    return Math.max(1, ofSpanUs / MOMENTS);
  }

  /** How far back events are shown. */
  void setSpan(long newSpanUs) {
    spanUs = newSpanUs;
  }

  FrameExchange<Frame> exchange() {
    return exchange;
  }

  @Override
  public void packet(EventPacket packet) {
    cloud.packet(packet);
    if (!packet.isEmpty()) {
      advanceTo(packet.lastTimeUs());
    }
  }

  /** Extrapolates the marks to a time. */
  private void advanceTo(long timeUs) {
    long stepUs = stepUs(spanUs);
    tracedUs = Math.max(tracedUs, timeUs - spanUs);
    while (tracedUs + stepUs <= timeUs) {
      tracedUs += stepUs;
      traces.add(tracedUs, marks);
    }
    nowUs = timeUs;
    traces.removeBefore(nowUs - spanUs);
    marks = snapshots.marks();
  }

  @Override
  public void notified(StreamNotification notification) {
    cloud.notified(notification);
    snapshots.notified(notification);
    if (notification.restartsTime()) {
      traces.clear();
      marks = List.of();
      tracedUs = 0;
    }
  }

  @Override
  public long memoryUs(long sliceUs) {
    return spanUs;
  }

  @Override
  public void runUpBegins(long sliceUs) {
    snapshots.followChain();
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    cloud.advanceTo(toUs);
    advanceTo(toUs);
    if (!exchange.isPending()) {
      sliceHeld();
    }
  }

  @Override
  public void sliceHeld() {
    Frame frame = exchange.back();
    cloud.copyTo(spanUs, frame.points);
    frame.nowUs = nowUs;
    frame.marks = marks;
    frame.traces = traces.copy();
    exchange.publish();
  }

  /** Ends all subscriptions; processing thread. */
  void close() {
    snapshots.close();
  }
}
