package haltere.ui.viewer.picture;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.playback.SliceSink;
import haltere.core.stream.StreamNotification;
import haltere.ui.rendering.LayerTaps;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;

/**
 * The end of the chain that makes pictures: the newest snapshot of each overlay is kept here,
 * events are gathered and painted by a {@link PictureMaker}, on a {@link PictureThread} of its own
 * or at once. Where two chains are compared, the second one's pictures come {@link #beside} the
 * first one's, never alone.
 *
 * <p>Thread rule: processing thread; {@link #maker()} and {@link #setAllEvents} are for the JavaFX
 * thread.
 */
public final class DisplaySink implements SliceSink {
  private final LayerTaps taps;
  private final PictureMaker maker;
  private final Optional<PictureThread> thread;
  private final Consumer<EventPacket> packets;

  /** Does something behind the packets that were handed over. */
  private final Executor steps;

  final PassedEvents passed = new PassedEvents();
  private volatile boolean allEvents;

  private DisplaySink(FilterChain chain, PictureMaker maker, Optional<PictureThread> thread) {
    this.maker = maker;
    this.thread = thread;
    taps = new LayerTaps(chain);
    Consumer<EventPacket> paints = maker::packet;
    packets =
        thread
            .<Consumer<EventPacket>>map(apart -> packet -> apart.packet(packet, paints))
            .orElse(paints);
    steps = thread.<Executor>map(apart -> apart::later).orElse(Runnable::run);
  }

  /** One that paints on the thread of the chain. */
  public static DisplaySink direct(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    return new DisplaySink(chain, new PictureMaker(geometry, options, false), Optional.empty());
  }

  /** One that paints on a thread of its own. */
  public static DisplaySink apart(
      SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    PictureMaker maker = new PictureMaker(geometry, options, true);
    return new DisplaySink(chain, maker, Optional.of(new PictureThread()));
  }

  /**
   * One whose pictures come with those of this one, of the same moments: it takes the same packets,
   * slices and notifications, each before this one does.
   */
  public DisplaySink beside(FilterChain chain) {
    return new DisplaySink(chain, maker.beside(), thread);
  }

  /** What paints, for whoever shows its frames or wants them otherwise. */
  public PictureMaker maker() {
    return maker;
  }

  /** Shows the frame that was there before the place of the last jump. */
  public void giveFrame(Frame frame) {
    if (maker.frames().give(frame)) {
      maker.setStale(true);
    }
  }

  /** Shows frames of 16 bits by the bits that those of the whole recording use. */
  public void useFrameBits(int bits) {
    maker.frames().useBits(bits);
    maker.setStale(true);
  }

  @Override
  public void sample(SensorSample sample) {
    if (sample instanceof Frame frame) {
      steps.execute(() -> maker.frames().take(frame));
    }
  }

  /** Shows events as they come, before the chain, or those that it leaves. */
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
        // the display takes it behind the chain
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
    boolean anew = taps.notified(notification);
    steps.execute(
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
    steps.execute(() -> maker.endSlice(fromUs, toUs));
  }

  @Override
  public long memoryUs(long sliceUs) {
    return maker.memoryUs(sliceUs);
  }

  @Override
  public void runUpBegins(long sliceUs) {
    taps.followChain();
    steps.execute(() -> maker.runUpBegins(sliceUs));
  }

  @Override
  public void runUpEnds() {
    passed.discard();
    steps.execute(maker::runUpEnds);
  }

  @Override
  public void sliceHeld() {
    passed.hold();
    List<LayerTaps.Marks<?>> marks = taps.marks();
    steps.execute(() -> maker.hold(marks));
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    passed.endSlice();
    List<LayerTaps.Marks<?>> marks = taps.marks();
    steps.execute(() -> maker.showSlice(fromUs, toUs, marks));
  }

  /** Paints what there is and hands it over. */
  public void paint() {
    List<LayerTaps.Marks<?>> marks = taps.marks();
    maker.setStale(false);
    steps.execute(() -> maker.paint(marks));
  }

  /** A picture of the present moment of usual size, with what lies over it. */
  public BufferedImage picture(Overlays overlays) {
    List<LayerTaps.Marks<?>> marks = taps.marks();
    return thread
        .map(apart -> apart.now(() -> maker.picture(overlays, marks)))
        .orElseGet(() -> maker.picture(overlays, marks));
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  public void close() {
    taps.close();
    if (!maker.leave()) {
      thread.ifPresent(PictureThread::close);
    }
  }
}
