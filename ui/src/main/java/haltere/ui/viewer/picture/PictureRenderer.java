package haltere.ui.viewer.picture;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamNotification;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.rendering.ColourScale;
import haltere.ui.rendering.EventPicture;
import haltere.ui.rendering.FrameExchange;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.PictureStamp;
import haltere.ui.rendering.PictureStyle;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.controls.Texts;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;

/**
 * Accumulates events, and paints a frame for the window at the end of a slice.
 *
 * <p>Where slices end faster than the window shows frames, some are not painted; {@link #isStale()}
 * then tells the window to ask for the last one. While slices run on, and events fade, one is also
 * painted in the midst of a slice where the window would have none for its next pulse.
 *
 * <p>A renderer {@link #beside} another one is painted when that is, as part of its frame.
 *
 * <p>Thread rule: {@link #setOptions}, {@link #setScreenMapping}, {@link #point}, {@link
 * #setRegion}, {@link #isStale()} and the exchange's showing side from any thread, all else on the
 * thread that paints.
 */
public final class PictureRenderer {
  /** Minimum interval at which frames that nobody has fetched are replaced. */
  private static final long MIN_FRAME_NANOS = 25_000_000;

  /** Slices within this time of each other are continuous playback. */
  private static final long RUNNING_NANOS = 20_000_000;

  /** While slices run on, the window waits at most so long for one to end. */
  private static final long MAX_WAIT_NANOS = 1_500_000;

  private final EventPicture events;
  private final ViewProbes probes = new ViewProbes();
  private final FrameLayer frames;
  private final FrameExchange<DisplayFrame> exchange;

  /** The renderer that this one is painted with, and the one that is painted with this one. */
  private final Optional<PictureRenderer> first;

  private volatile Optional<PictureRenderer> second = Optional.empty();
  private volatile boolean left;
  private volatile DisplayOptions options;
  private final ScreenPainter painter = new ScreenPainter();
  private volatile Optional<ScreenMapping> screenMapping = Optional.empty();
  private volatile boolean stale;
  private double sliceUs = 8_333;
  private long lastSliceUs = 8_333;

  /** Start of the last slice, the moment that the window names. */
  private long sliceFromUs = StreamNotification.NO_TIME_US;

  private boolean holds;
  private final boolean betweenSlices;
  private List<OverlaySnapshots.Marks<?>> lastMarks = List.of();
  private long paintedNanos;
  private long sliceEndNanos;
  private boolean runsOn;
  private boolean waits;
  private long waitsFromNanos;
  private boolean exposed;

  /**
   * A renderer without events, which may also paint in the midst of a slice, or is painted with
   * another one, see the class comment.
   */
  PictureRenderer(
      SensorGeometry geometry,
      DisplayOptions options,
      boolean betweenSlices,
      Optional<PictureRenderer> first) {
    this.options = options;
    this.betweenSlices = betweenSlices;
    this.first = first;
    frames = first.map(PictureRenderer::frames).orElseGet(FrameLayer::new);
    events = new EventPicture(geometry, style());
    exchange =
        first
            .map(PictureRenderer::exchange)
            .orElseGet(() -> new FrameExchange<>(() -> new DisplayFrame(geometry)));
  }

  /** One whose pictures are part of this one's frames, from the end of its first slice on. */
  PictureRenderer beside() {
    return new PictureRenderer(events.frame().geometry(), options, false, Optional.of(this));
  }

  /** Ends joint painting with another one; false without it. */
  boolean leave() {
    left = true;
    first.ifPresent(renderer -> renderer.second = Optional.empty());
    return first.isPresent();
  }

  /** The exchange of finished frames. */
  public FrameExchange<DisplayFrame> exchange() {
    return exchange;
  }

  /** The camera's frames below the events. */
  public FrameLayer frames() {
    return frames;
  }

  /** Shows events in another way from the next frame on. */
  public void setOptions(DisplayOptions newOptions) {
    options = newOptions;
    stale = true;
  }

  /** Sets the mapping for frames in screen resolution, or none if they are drawn elsewhere. */
  public void setScreenMapping(Optional<ScreenMapping> mapping) {
    screenMapping = mapping;
  }

  /** The mouse is over a pixel, or over none. */
  public void point(Optional<PixelRegion> pixel) {
    probes.point(pixel);
    stale = true;
  }

  /** The region of interest, or none. */
  public void setRegion(Optional<PixelRegion> region) {
    probes.setRegion(region);
    stale = true;
  }

  /** Whether there is newer data than the last published frame. */
  public boolean isStale() {
    return stale;
  }

  /** Sets whether another frame is needed, or about to come. */
  void setStale(boolean isStale) {
    stale = isStale;
  }

  /** A run-up to a slice begins; the picture is unchanged until it ends. */
  void runUpBegins(long newSliceUs) {
    lastSliceUs = newSliceUs;
    sliceUs = newSliceUs;
    events.configure(style());
    holds = true;
  }

  /** The next slice to be shown begins. */
  void runUpEnds() {
    exposed = true;
  }

  /** Holds the last slice, if any: its picture shows its events alone. */
  void hold(List<OverlaySnapshots.Marks<?>> marks) {
    holds = false;
    sliceUs = lastSliceUs;
    events.settle();
    probes.settle();
    paint(marks);
  }

  void packet(EventPacket packet) {
    beginExposure();
    events.packet(packet);
    probes.packet(packet);
    if (betweenSlices && runsOn && !events.style().sharp() && isOverdue()) {
      paint(lastMarks);
    }
  }

  private void beginExposure() {
    if (exposed) {
      events.beginExposure();
      exposed = false;
    }
  }

  /** Whether the window has been without a new frame for too long. */
  private boolean isOverdue() {
    boolean waited = waits;
    waits = !exchange.isPending();
    if (!waits) {
      return false;
    }
    long nanos = System.nanoTime();
    if (!waited) {
      waitsFromNanos = nanos;
    }
    return nanos - waitsFromNanos >= MAX_WAIT_NANOS;
  }

  void notified(StreamNotification notification) {
    events.notified(notification);
    probes.notified(notification);
    runsOn = false;
  }

  /** Ends a slice without a frame. */
  void endSlice(long fromUs, long toUs) {
    events.advanceTo(toUs);
    beginExposure();
    holds = false;
    first.ifPresent(renderer -> renderer.second = left ? Optional.empty() : Optional.of(this));
    sliceFromUs = fromUs;
    lastSliceUs = toUs - fromUs;
    sliceUs += 0.25 * (lastSliceUs - sliceUs);
    exposed = true;
  }

  /** A slice ends; its frame is painted unless the window has no use for it. */
  void showSlice(long fromUs, long toUs, List<OverlaySnapshots.Marks<?>> marks) {
    endSlice(fromUs, toUs);
    lastMarks = marks;
    long nanos = System.nanoTime();
    runsOn = nanos - sliceEndNanos < RUNNING_NANOS;
    sliceEndNanos = nanos;
    if (exchange.isPending() && nanos - paintedNanos < MIN_FRAME_NANOS) {
      stale = true;
    } else {
      paint(marks);
    }
  }

  /** Paints and publishes a frame. */
  void paint(List<OverlaySnapshots.Marks<?>> marks) {
    lastMarks = marks;
    // two chains may differ in progress within a slice
    stale = holds || second.isPresent() && !exposed;
    if (stale || first.isPresent()) {
      return;
    }
    DisplayFrame frame = exchange.back();
    frame.beside =
        second.map(
            renderer -> {
              DisplayFrame with = frame.beside.orElseGet(() -> new DisplayFrame(frame.geometry));
              renderer.fill(with);
              return with;
            });
    fill(frame);
    frame.screenMapping = screenMapping;
    frame.screenMapping.ifPresent(mapping -> paintScreen(frame, mapping));
    exchange.publish();
    paintedNanos = System.nanoTime();
  }

  private void fill(DisplayFrame frame) {
    paintPixels(frame.pixels);
    frame.pixel = probes.pixel(events);
    frame.region = probes.region(events.frame().nowUs());
    frame.scale = scale();
    frame.timeUs = events.frame().nowUs();
    frame.dark = events.style().dark();
    frame.marks = lastMarks;
  }

  private void paintPixels(int[] ranked) {
    SensorGeometry geometry = events.frame().geometry();
    events.configure(style());
    events.paintRanked(ranked);
    frames.paintUnder(ranked, geometry, events.style().background(), options().frameOpacity());
  }

  private void paintScreen(DisplayFrame frame, ScreenMapping mapping) {
    int size = mapping.columns() * mapping.rows();
    if (frame.screen.length != size) {
      frame.screen = new int[size];
    }
    painter.configure(frame.geometry, mapping);
    painter.paint(frame, frame.screen);
  }

  /** A picture of the present moment in default size, with overlays. */
  BufferedImage picture(Overlays overlays, List<OverlaySnapshots.Marks<?>> marks) {
    SensorGeometry geometry = events.frame().geometry();
    int[] argb = new int[geometry.pixels()];
    paintPixels(argb);
    for (int i = 0; i < argb.length; i++) {
      argb[i] |= 0xFF000000;
    }
    Optional<RegionMarks> region =
        overlays
            .region()
            .map(pixels -> new RegionMarks(pixels, probes.regionNow(events.frame().nowUs())));
    boolean dark = events.style().dark();
    BufferedImage picture =
        Pictures.draw(
            geometry,
            argb,
            dark,
            Pictures.defaultScale(geometry),
            canvas -> {
              if (overlays.marks()) {
                marks.forEach(snapshot -> snapshot.draw(events.frame().nowUs(), canvas));
              }
              region.ifPresent(drawn -> drawn.draw(canvas));
              overlays.tape().ifPresent(line -> line.draw(canvas));
            });
    PictureStyle style = events.style();
    PictureStamp stamp = new PictureStamp(picture, dark);
    stamp.scaleBar(Pictures.defaultScale(geometry));
    ColourScale.of(style.mode(), style.gradient(), scale()).ifPresent(stamp::colours);
    if (sliceFromUs != StreamNotification.NO_TIME_US) {
      stamp.label(sliceFromUs + " \u00b5s");
    }
    return picture;
  }

  /** Time before a slice whose events affect its picture and measurements at positions. */
  long memoryUs(long ofSliceUs) {
    long fadingUs = Math.round(style(ofSliceUs, ofSliceUs).maxAgeUs());
    return Math.max(Math.max(fadingUs, EventPicture.memoryUs(options().mode())), probes.memoryUs());
  }

  private DisplayOptions options() {
    return first.map(renderer -> renderer.options).orElse(options);
  }

  private PictureStyle style() {
    return style(lastSliceUs, sliceUs);
  }

  private PictureStyle style(long exposureUs, double fadingSliceUs) {
    DisplayOptions now = options();
    if (now.decayUs() == DisplayOptions.ACCUMULATE) {
      return PictureStyle.accumulated(now.mode(), now.colours(), now.gradient());
    }
    boolean sharp = now.decayUs() == DisplayOptions.SLICE_ONLY;
    long us = sharp ? exposureUs : now.forSlices(fadingSliceUs).decayUs();
    return new PictureStyle(
        now.mode(),
        now.colours(),
        now.gradient(),
        Math.max(1, Math.min(FramePainter.MAX_TIME_CONSTANT_US, us)),
        sharp);
  }

  /** Meaning of the ends of a gradient. */
  private String scale() {
    PictureStyle style = events.style();
    return switch (style.mode()) {
      case COUNTS -> Texts.digits(events.fullCount()) + " events";
      case TIME_SURFACE -> Texts.duration(style.maxAgeUs()) + " ago";
      case FREQUENCY -> "1 kHz" + (events.isWithoutFlicker() ? ", no pixel flickers" : "");
      default -> "";
    };
  }
}
