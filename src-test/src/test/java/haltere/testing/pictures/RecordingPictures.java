package haltere.testing.pictures;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.track.TrackPoint;
import haltere.testing.Recorded;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.EventFrame;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.Pictures;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Draws each recording of the folder of recordings after a third, a half and nine tenths of its
 * events, the part of the sensor in which they are, with the clusters above and the tracks below,
 * for a person to look at, and prints {@link TracksSeen}'s figures of each: {@code ./gradlew
 * :src-test:pictureRecordings}. For the documentation, the tracks only, smaller, and each scene
 * once: {@code -Pdocs}.
 */
public final class RecordingPictures {
  private static final double[] SHARES = {1 / 3.0, 0.5, 0.9};
  private static final int PANEL_PX = 512;
  private static final int DOCS_PANEL_PX = 280;
  private static final int GAP_PX = 4;
  private static final long FADING_US = 15_000;

  /** The same scenes as others, in other formats. */
  private static final Set<String> AGAIN =
      Set.of(
          "atis.es",
          "davis346-by-eventcv.h5",
          "davis346-by-evutils.h5",
          "gen3-evt21-by-evutils.raw",
          "gen4.dat");

  private final List<String> trackers;
  private final int panelPx;

  private RecordingPictures(List<String> trackers, int panelPx) {
    this.trackers = trackers;
    this.panelPx = panelPx;
  }

  /**
   * Draws them all.
   *
   * @param arguments the folder for the pictures, and {@code docs} if they are for the
   *     documentation
   */
  public static void main(String[] arguments) throws IOException {
    Path pictures = Path.of(arguments[0]);
    Files.createDirectories(pictures);
    boolean docs = List.of(arguments).contains("docs");
    RecordingPictures all =
        docs
            ? new RecordingPictures(List.of("kalman-tracks"), DOCS_PANEL_PX)
            : new RecordingPictures(List.of("cluster-tracker", "kalman-tracks"), PANEL_PX);
    List<Path> files;
    try (Stream<Path> found = Files.list(Recorded.folder())) {
      files = found.filter(Files::isRegularFile).sorted().toList();
    }
    for (Path file : files) {
      String name = file.getFileName().toString();
      if (!docs || !AGAIN.contains(name)) {
        System.out.println(name + ": " + all.draw(file, pictures.resolve(name + ".png")));
      }
    }
  }

  /** Draws a recording; what came of it. */
  private String draw(Path file, Path picture) {
    try {
      BusyPart part = part(file);
      if (part.events() == 0) {
        return "no events";
      }
      List<BufferedImage> panels = new ArrayList<>();
      TracksSeen seen = null;
      for (String tracker : trackers) {
        Painter painter = paint(file, tracker, part);
        panels.addAll(painter.panels);
        seen = painter.seen;
      }
      Pictures.write(picture, sheet(panels));
      return seen.figures();
    } catch (IOException unreadable) {
      return "not drawn: " + unreadable.getMessage();
    }
  }

  private static BusyPart part(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      BusyPart part = new BusyPart(reader.geometry());
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              part.add(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              // only events are counted
            }
          });
      part.settle();
      return part;
    }
  }

  private Painter paint(Path file, String tracker, BusyPart part) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      FilterChain chain = new FilterChain(reader.geometry());
      for (String name : List.of("background-activity", "hot-pixels", tracker)) {
        chain.add(Filters.named(name));
      }
      Painter painter = new Painter(chain, part, part.scale(panelPx));
      Pipeline.run(reader, chain, List.of(painter), painter.counters);
      chain.close();
      return painter;
    }
  }

  private BufferedImage sheet(List<BufferedImage> panels) {
    int columns = SHARES.length;
    int width = panels.get(0).getWidth() + GAP_PX;
    int height = panels.get(0).getHeight() + GAP_PX;
    BufferedImage sheet =
        new BufferedImage(columns * width, trackers.size() * height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = sheet.createGraphics();
    for (int i = 0; i < panels.size(); i++) {
      graphics.drawImage(panels.get(i), i % columns * width, i / columns * height, null);
    }
    graphics.dispose();
    return sheet;
  }

  /** A layer and what it showed last. */
  private static final class Marks<T> {
    private final OverlayLayer<T> layer;
    private T last;

    Marks(OverlayLayer<T> layer) {
      this.layer = layer;
      layer.subscribe().apply(snapshot -> last = snapshot);
    }

    void draw(OverlayCanvas canvas) {
      if (last != null) {
        layer.overlay().draw(last, canvas);
      }
    }
  }

  /** Draws when enough events have come. */
  private static final class Painter implements StreamHandler {
    private final PipelineCounters counters = new PipelineCounters();
    private final List<BufferedImage> panels = new ArrayList<>();
    private final List<Marks<?>> marks = new ArrayList<>();
    private final EventFrame frame;
    private final BusyPart part;
    private final int scale;
    private final TracksSeen seen;

    Painter(FilterChain chain, BusyPart part, int scale) {
      this.part = part;
      this.scale = scale;
      frame = new EventFrame(chain.geometry());
      for (OverlayLayer<?> layer : chain.overlays()) {
        marks.add(new Marks<>(layer));
      }
      seen = new TracksSeen(chain.geometry());
      if (chain.outlets().stream().anyMatch(outlet -> outlet.name().equals("tracks"))) {
        chain.outlet("tracks", TrackPoint.class).subscribe(seen::shown);
      }
    }

    @Override
    public void packet(EventPacket packet) {
      frame.packet(packet);
      seen.packet(packet);
      long come = counters.get(PipelineCounters.Counter.EVENTS_IN);
      while (panels.size() < SHARES.length && come >= SHARES[panels.size()] * part.events()) {
        panels.add(panel());
      }
    }

    private BufferedImage panel() {
      BufferedImage whole =
          Pictures.draw(
              frame,
              new FramePainter(ColourMap.DARK, FADING_US),
              scale,
              canvas -> marks.forEach(one -> one.draw(canvas)));
      return part.cut(whole, scale);
    }

    @Override
    public void notified(StreamNotification notification) {
      frame.notified(notification);
    }
  }
}
