package haltere.ui.viewer.picture;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.rendering.OverlaySnapshots;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;

/**
 * The sink of the chain for pictures: keeps the newest snapshot of each overlay and passes events
 * to a {@link PictureRenderer}, on a {@link PictureThread} or directly. With two chains, the second
 * one's pictures are painted {@link #beside} the first one's.
 *
 * <p>Thread rule: processing thread; {@link #renderer()} and {@link #setAllEvents} are for the
 * JavaFX thread.
 */
public final class DisplaySink implements SliceSink {
  private final OverlaySnapshots snapshots;
  private final PictureRenderer renderer;
  private final Optional<PictureThread> thread;
  private final Consumer<EventPacket> packets;

  /** Runs a task after the packets sent so far. */
  private final Executor steps;

  final PassedEvents passed = new PassedEvents();
  private volatile boolean allEvents;

  private DisplaySink(FilterChain chain, PictureRenderer renderer, Optional<PictureThread> thread) {
    this.renderer = renderer;
    this.thread = thread;
    snapshots = new OverlaySnapshots(chain);
    Consumer<EventPacket> paints = renderer::packet;
    packets =
        thread
            .<Consumer<EventPacket>>map(painter -> packet -> painter.packet(packet, paints))
            .orElse(paints);
    steps = thread.<Executor>map(painter -> painter::later).orElse(Runnable::run);
  }

  /** One that paints on the thread of the chain. */
  public static DisplaySink direct(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    var renderer = new PictureRenderer(geometry, options, false, Optional.empty());
    return new DisplaySink(chain, renderer, Optional.empty());
  }

  /** One that paints on a thread of its own. */
  public static DisplaySink onOwnThread(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    var renderer = new PictureRenderer(geometry, options, true, Optional.empty());
    return new DisplaySink(chain, renderer, Optional.of(new PictureThread()));
  }

  /**
   * A sink whose pictures are painted with this one's, of the same moments: it gets the same
   * packets, slices and notifications, each before this one.
   */
  public DisplaySink beside(FilterChain chain) {
    return new DisplaySink(chain, renderer.beside(), thread);
  }

  /** The renderer of its frames. */
  public PictureRenderer renderer() {
    return renderer;
  }

  /** Shows the frame before the position of the last jump. */
  public void giveFrame(Frame frame) {
    if (renderer.frames().give(frame)) {
      renderer.setStale(true);
    }
  }

  /** Shows frames of 16 bits by the bits that those of the whole recording use. */
  public void useFrameBits(int bits) {
    renderer.frames().useBits(bits);
    renderer.setStale(true);
  }

  @Override
  public void sample(SensorSample sample) {
    if (sample instanceof Frame frame) {
      steps.execute(() -> renderer.frames().take(frame));
    }
  }

  /** Shows the events before the chain, or those that it passes. */
  public void setAllEvents(boolean all) {
    allEvents = all;
  }

  /** Takes the events before the chain, also those of run-ups. */
  public SliceSink beforeChain() {
    return new SliceSink() {
      @Override
      public void packet(EventPacket packet) {
        passed.before += packet.size();
        if (allEvents) {
          packets.accept(packet);
        }
      }

      @Override
      public void sliceEnd(long fromUs, long toUs) {
        // the display gets it after the chain
      }
    };
  }

  @Override
  public void packet(EventPacket packet) {
    passed.after += packet.size();
    if (!allEvents) {
      packets.accept(packet);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    snapshots.notified(notification);
    steps.execute(
        () -> {
          renderer.notified(notification);
          if (notification.restartsTime()) {
            renderer.frames().jump();
            renderer.setStale(true);
          }
        });
  }

  /** Ends a slice whose picture is requested by {@link #picture}. */
  public void endSlice(long fromUs, long toUs) {
    steps.execute(() -> renderer.endSlice(fromUs, toUs));
  }

  @Override
  public long memoryUs(long sliceUs) {
    return renderer.memoryUs(sliceUs);
  }

  @Override
  public void runUpBegins(long sliceUs) {
    snapshots.followChain();
    steps.execute(() -> renderer.runUpBegins(sliceUs));
  }

  @Override
  public void runUpEnds() {
    passed.discard();
    steps.execute(renderer::runUpEnds);
  }

  @Override
  public void sliceHeld() {
    passed.hold();
    List<OverlaySnapshots.Marks<?>> marks = snapshots.marks();
    steps.execute(() -> renderer.hold(marks));
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    passed.endSlice();
    List<OverlaySnapshots.Marks<?>> marks = snapshots.marks();
    steps.execute(() -> renderer.showSlice(fromUs, toUs, marks));
  }

  /** Paints and publishes a frame. */
  public void paint() {
    List<OverlaySnapshots.Marks<?>> marks = snapshots.marks();
    renderer.setStale(false);
    steps.execute(() -> renderer.paint(marks));
  }

  /** A picture of the present moment in default size, with overlays. */
  public BufferedImage picture(Overlays overlays) {
    List<OverlaySnapshots.Marks<?>> marks = snapshots.marks();
    return thread
        .map(painter -> painter.now(() -> renderer.picture(overlays, marks)))
        .orElseGet(() -> renderer.picture(overlays, marks));
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  public void close() {
    snapshots.close();
    if (!renderer.leave()) {
      thread.ifPresent(PictureThread::close);
    }
  }
}
