package haltere.testing.pictures;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.overlay.OverlayLayer;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
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
import java.util.stream.Stream;

/**
 * Draws each recording of the folder of recordings after a third, a half and nine tenths of its
 * events, with the clusters above and the tracks below, for a person to look at: {@code ./gradlew
 * :src-test:pictureRecordings}.
 */
public final class RecordingPictures {
  private static final double[] SHARES = {1 / 3.0, 0.5, 0.9};
  private static final List<String> TRACKERS = List.of("cluster-tracker", "kalman-tracks");
  private static final int PANEL_PX = 512;
  private static final int GAP_PX = 4;
  private static final long FADING_US = 15_000;

  private RecordingPictures() {}

  /**
   * Draws them all.
   *
   * @param arguments the folder for the pictures
   */
  public static void main(String[] arguments) throws IOException {
    Path pictures = Path.of(arguments[0]);
    Files.createDirectories(pictures);
    List<Path> files;
    try (Stream<Path> found = Files.list(Recorded.folder())) {
      files = found.filter(Files::isRegularFile).sorted().toList();
    }
    for (Path file : files) {
      Path picture = pictures.resolve(file.getFileName() + ".png");
      System.out.println(file.getFileName() + ": " + draw(file, picture));
    }
  }

  /** Draws a recording; what came of it. */
  private static String draw(Path file, Path picture) {
    try {
      long events = events(file);
      if (events == 0) {
        return "no events";
      }
      List<BufferedImage> panels = new ArrayList<>();
      for (String tracker : TRACKERS) {
        panels.addAll(panels(file, tracker, events));
      }
      Pictures.write(picture, sheet(panels));
      return picture.toString();
    } catch (IOException unreadable) {
      return "not drawn: " + unreadable.getMessage();
    }
  }

  private static long events(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      long[] count = new long[1];
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              count[0] += packet.size();
            }

            @Override
            public void notified(StreamNotification notification) {
              // only events are counted
            }
          });
      return count[0];
    }
  }

  private static List<BufferedImage> panels(Path file, String tracker, long events)
      throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      FilterChain chain = new FilterChain(reader.geometry());
      for (String name : List.of("background-activity", "hot-pixels", tracker)) {
        chain.add(Filters.named(name));
      }
      Painter painter = new Painter(chain, events);
      Pipeline.run(reader, chain, List.of(painter), painter.counters);
      chain.close();
      return painter.panels;
    }
  }

  private static BufferedImage sheet(List<BufferedImage> panels) {
    int columns = SHARES.length;
    int width = panels.get(0).getWidth() + GAP_PX;
    int height = panels.get(0).getHeight() + GAP_PX;
    BufferedImage sheet =
        new BufferedImage(columns * width, TRACKERS.size() * height, BufferedImage.TYPE_INT_RGB);
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
    private final long events;

    Painter(FilterChain chain, long events) {
      this.events = events;
      frame = new EventFrame(chain.geometry());
      for (OverlayLayer<?> layer : chain.overlays()) {
        marks.add(new Marks<>(layer));
      }
    }

    @Override
    public void packet(EventPacket packet) {
      frame.packet(packet);
      long come = counters.get(PipelineCounters.Counter.EVENTS_IN);
      while (panels.size() < SHARES.length && come >= SHARES[panels.size()] * events) {
        panels.add(panel());
      }
    }

    private BufferedImage panel() {
      SensorGeometry geometry = frame.geometry();
      return Pictures.draw(
          frame,
          new FramePainter(ColourMap.DARK, FADING_US),
          Math.max(1, PANEL_PX / geometry.longerSide()),
          canvas -> marks.forEach(one -> one.draw(canvas)));
    }

    @Override
    public void notified(StreamNotification notification) {
      frame.notified(notification);
    }
  }
}
