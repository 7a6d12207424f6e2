package haltere.ui.viewer;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayLayer;
import haltere.core.playback.SliceSink;
import haltere.core.stream.DataLost;
import haltere.core.stream.StreamNotification;
import haltere.ui.measure.PixelRegion;
import haltere.ui.rendering.EventPicture;
import haltere.ui.rendering.FrameExchange;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.PictureStyle;
import haltere.ui.rendering.Pictures;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The end of the chain that makes pictures: gathers events and the newest snapshot of each overlay,
 * and at the end of a slice paints a frame for the window to fetch.
 *
 * <p>Where slices end faster than the window shows frames, some are not painted; {@link #isStale()}
 * then tells the window to ask for the last one.
 *
 * <p>Thread rule: {@link #setOptions}, {@link #isStale()} and the exchange's showing side are for
 * the JavaFX thread, all else for the processing thread.
 */
final class DisplaySink implements SliceSink {
  /** No more than one frame in this time replaces another that nobody has seen. */
  private static final long MIN_FRAME_NANOS = 25_000_000;

  /** Decay that follows the slices: this many times their length, within these limits. */
  private static final double DECAY_PER_SLICE = 2.5;

  private static final double MIN_DECAY_US = 20;
  private static final double MAX_DECAY_US = 1_000_000;

  private final FilterChain chain;
  private final EventPicture events;
  private final ViewProbes probes = new ViewProbes();
  private final FrameExchange<DisplayFrame> exchange;
  private final List<LayerTap<?>> taps = new ArrayList<>();
  private volatile DisplayOptions options;
  private volatile boolean stale;
  private double sliceUs = 8_333;
  private long lastSliceUs = 8_333;
  private long paintedNanos;
  private boolean exposed;

  DisplaySink(SensorGeometry geometry, FilterChain chain, DisplayOptions options) {
    this.chain = chain;
    this.options = options;
    events = new EventPicture(geometry, style());
    exchange = new FrameExchange<>(() -> new DisplayFrame(geometry));
  }

  FrameExchange<DisplayFrame> exchange() {
    return exchange;
  }

  void setOptions(DisplayOptions newOptions) {
    options = newOptions;
    stale = true;
  }

  /** The mouse is over a pixel, or over none. */
  void point(int x, int y, boolean over) {
    probes.point(x, y, over);
    stale = true;
  }

  /** The region of interest, or none. */
  void setRegion(Optional<PixelRegion> region) {
    probes.setRegion(region);
    stale = true;
  }

  /** Whether there is something newer than the frame that was published last. */
  boolean isStale() {
    return stale;
  }

  @Override
  public void packet(EventPacket packet) {
    if (exposed) {
      events.beginExposure();
      exposed = false;
    }
    events.packet(packet);
    probes.packet(packet);
  }

  @Override
  public void notified(StreamNotification notification) {
    events.notified(notification);
    probes.notified(notification);
    if (notification.endsContinuity() && !(notification instanceof DataLost)) {
      for (LayerTap<?> tap : taps) {
        tap.clear();
      }
      stale = true;
    }
  }

  /** A slice ends whose picture is asked for by {@link #picture}. */
  void endSlice(long fromUs, long toUs) {
    advance(fromUs, toUs);
    exposed = true;
  }

  private void advance(long fromUs, long toUs) {
    events.advanceTo(toUs);
    lastSliceUs = toUs - fromUs;
    sliceUs += 0.25 * (lastSliceUs - sliceUs);
  }

  @Override
  public void sliceEnd(long fromUs, long toUs) {
    advance(fromUs, toUs);
    if (exchange.isPending() && System.nanoTime() - paintedNanos < MIN_FRAME_NANOS) {
      stale = true;
    } else {
      paint();
    }
    exposed = true;
  }

  /** Paints what there is and hands it over. */
  void paint() {
    stale = false;
    followChain();
    events.configure(style());
    DisplayFrame frame = exchange.back();
    events.paintRanked(frame.pixels);
    frame.pixel = probes.pixel(events.frame());
    frame.region = probes.region(events.frame().nowUs());
    frame.scale = scale();
    frame.timeUs = events.frame().nowUs();
    frame.dark = events.style().dark();
    frame.marks = marks();
    exchange.publish();
    paintedNanos = System.nanoTime();
  }

  /** A picture of the present moment of usual size, with its marks. */
  BufferedImage picture() {
    followChain();
    events.configure(style());
    SensorGeometry geometry = events.frame().geometry();
    int[] argb = new int[geometry.pixels()];
    events.paint(argb);
    List<DisplayFrame.Marks<?>> marks = marks();
    return Pictures.draw(
        geometry,
        argb,
        events.style().dark(),
        Pictures.usualScale(geometry),
        canvas -> marks.forEach(snapshot -> snapshot.draw(canvas)));
  }

  /** Ends all subscriptions; the processing thread has ended or calls this. */
  void close() {
    for (LayerTap<?> tap : taps) {
      tap.close();
    }
    taps.clear();
  }

  private PictureStyle style() {
    DisplayOptions now = options;
    boolean sharp = now.decayUs() == DisplayOptions.SLICE_ONLY;
    long us = sharp ? lastSliceUs : decayUs(now.decayUs());
    return new PictureStyle(
        now.mode(),
        now.colours(),
        now.gradient(),
        Math.max(1, Math.min(FramePainter.LONGEST_TIME_CONSTANT_US, us)),
        sharp);
  }

  /** What the ends of a gradient stand for. */
  private String scale() {
    PictureStyle style = events.style();
    return switch (style.mode()) {
      case COUNTS -> Texts.digits(events.fullCount()) + " events";
      case TIME_SURFACE -> Texts.duration(FramePainter.oldestUs(style)) + " ago";
      default -> "";
    };
  }

  private long decayUs(long chosen) {
    return chosen != DisplayOptions.FOLLOW_SLICES
        ? chosen
        : Math.round(Math.max(MIN_DECAY_US, Math.min(MAX_DECAY_US, sliceUs * DECAY_PER_SLICE)));
  }

  private List<DisplayFrame.Marks<?>> marks() {
    List<DisplayFrame.Marks<?>> marks = new ArrayList<>(taps.size());
    for (LayerTap<?> tap : taps) {
      DisplayFrame.Marks<?> latest = tap.latest();
      if (latest != null) {
        marks.add(latest);
      }
    }
    return marks;
  }

  /** Listens to the layers of the filters that are on now, whoever switched them. */
  private void followChain() {
    List<OverlayLayer<?>> layers = chain.overlays();
    taps.removeIf(
        tap -> {
          boolean gone = layers.stream().noneMatch(tap::isOf);
          if (gone) {
            tap.close();
          }
          return gone;
        });
    for (OverlayLayer<?> layer : layers) {
      if (taps.stream().noneMatch(tap -> tap.isOf(layer))) {
        taps.add(new LayerTap<>(layer));
      }
    }
  }

  /** Keeps the newest snapshot of one layer. Processing thread only. */
  private static final class LayerTap<T> {
    private final OverlayLayer<T> layer;
    private final AutoCloseable subscription;
    private T latest;

    LayerTap(OverlayLayer<T> layer) {
      this.layer = layer;
      this.subscription = layer.subscribe().apply(snapshot -> latest = snapshot);
    }

    boolean isOf(OverlayLayer<?> other) {
      return layer == other;
    }

    void clear() {
      latest = null;
    }

    DisplayFrame.Marks<T> latest() {
      return latest == null ? null : new DisplayFrame.Marks<>(latest, layer.overlay());
    }

    void close() {
      try {
        subscription.close();
      } catch (Exception broken) {
        throw new IllegalStateException("layer " + layer.name() + " cannot be left", broken);
      }
    }
  }
}
