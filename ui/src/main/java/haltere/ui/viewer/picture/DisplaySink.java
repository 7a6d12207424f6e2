package haltere.ui.viewer.picture;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;

/**
 * The end of the chain that makes pictures: the newest snapshot of each overlay is kept here,
 * events are gathered and painted by a {@link PictureMaker}, on a {@link PictureThread} of its own
 * or at once.
 *
 * <p>Thread rule: processing thread; {@link #maker()}, {@link #setFrameOpacity} and {@link
 * #setAllEvents} are for the JavaFX thread.
 */
public final class DisplaySink implements SliceSink {
  private final LayerTaps taps;
  private final PictureMaker maker;
  private final Optional<PictureThread> thread;
  private volatile boolean allEvents;

  private DisplaySink(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options, boolean apart) {
    taps = new LayerTaps(chain);
    maker = new PictureMaker(geometry, options, apart);
    thread = apart ? Optional.of(new PictureThread(maker::packet)) : Optional.empty();
  }

  /** One that paints on the thread of the chain. */
  public static DisplaySink direct(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    return new DisplaySink(geometry, chain, options, false);
  }

  /** One that paints on a thread of its own. */
  public static DisplaySink apart(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    return new DisplaySink(geometry, chain, options, true);
  }

  /** What paints, for whoever shows its frames or wants them otherwise. */
  public PictureMaker maker() {
    return maker;
  }

  /** Shows frames below the events: 0 not at all, 1 as they are. */
  public void setFrameOpacity(double opacity) {
    maker.frames().setOpacity(opacity);
    maker.setStale(true);
  }

  /** Shows the frame that was there before the place of the last jump. */
  public void giveFrame(Frame frame) {
    if (maker.frames().give(frame)) {
      maker.setStale(true);
    }
  }

  @Override
  public void sample(SensorSample sample) {
    if (sample instanceof Frame frame) {
      later(() -> maker.frames().take(frame));
    }
  }

  /** Shows events as they come, before the chain, or those that it leaves. */
  public void setAllEvents(boolean all) {
    allEvents = all;
  }

  /** Takes the events before the chain. */
  public void beforeChain(EventPacket packet) {
    if (allEvents) {
      gather(packet);
    }
  }

  @Override
  public void packet(EventPacket packet) {
    if (!allEvents) {
      gather(packet);
    }
  }

  private void gather(EventPacket packet) {
    if (thread.isPresent()) {
      thread.get().packet(packet);
    } else {
      maker.packet(packet);
    }
  }

  private void later(Runnable step) {
    thread.ifPresentOrElse(apart -> apart.later(step), step);
  }

  @Override
  public void notified(StreamNotification notification) {
    boolean anew = taps.notified(notification);
    later(
        () -> {
          maker.notified(notification);
          if (anew) {
            maker.frames().jump();
            maker.setStale(true);
          }
        });
  }

  /** A slice ends whose picture is asked for by {@link #picture}. */
  public void endSlice(long fromUs, long toUs) {
    later(() -> maker.endSlice(fromUs, toUs));
  }

  @Override
  public long memoryUs(long sliceUs) {
    return maker.memoryUs(sliceUs);
  }

  @Override
  public void runUpBegins(long sliceUs) {
    taps.followChain();
    later(() -> maker.runUpBegins(sliceUs));
  }

  @Override
  public void runUpEnds() {
    later(maker::runUpEnds);
  }

  @Override
  public void sliceHeld() {
    List<DisplayFrame.Marks<?>> marks = taps.marks();
    later(() -> maker.hold(marks));
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    List<DisplayFrame.Marks<?>> marks = taps.marks();
    later(() -> maker.showSlice(fromUs, toUs, marks));
  }

  /** Paints what there is and hands it over. */
  public void paint() {
    List<DisplayFrame.Marks<?>> marks = taps.marks();
    maker.setStale(false);
    later(() -> maker.paint(marks));
  }

  /** A picture of the present moment of usual size, with what lies over it. */
  public BufferedImage picture(Overlays overlays) {
    List<DisplayFrame.Marks<?>> marks = taps.marks();
    return thread
        .map(apart -> apart.now(() -> maker.picture(overlays, marks)))
        .orElseGet(() -> maker.picture(overlays, marks));
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  public void close() {
    taps.close();
    thread.ifPresent(PictureThread::close);
  }
}
