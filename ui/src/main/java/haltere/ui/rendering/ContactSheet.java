package haltere.ui.rendering;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.object.ObjectTrack;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Pictures of a stream at up to eight moments. The moments are at equal distances, however long the
 * stream is: where there are too many, each second one is dropped, and of those that are kept at
 * its end each second, third or fourth is drawn. Events fade so that a picture shows some percent
 * of the pixels. Objects that are reported after their moment are drawn in its picture all the
 * same.
 *
 * <p>Thread rule: one thread at a time. Needs no display.
 */
public final class ContactSheet implements StreamHandler {
  private static final int PANELS = 8;
  private static final int CANDIDATES = 4 * PANELS;
  private static final int COLUMNS = 4;
  private static final int PANEL_PX = 420;
  private static final int GAP_PX = 4;

  /** Distance of the first moments; a recording that is shorter gets fewer pictures. */
  private static final long FIRST_STEP_US = 5_000;

  /** Share of the pixels that have an event within the time constant of the fading. */
  private static final double VISIBLE_SHARE = 0.04;

  private static final double MIN_FADING_US = 1_000;
  private static final double MAX_FADING_US = 100_000;

  /** Packets this short are not cut, so that results of the same packet fit their events. */
  private static final long SHORT_US = 2_000;

  /**
   * The events of a moment, its time since the start and on the clock of the events, the results
   * known then, and later rows of its objects.
   */
  private record Panel(
      BufferedImage picture,
      long elapsedUs,
      long timeUs,
      List<OverlaySnapshots.Marks<?>> marks,
      Map<Integer, ObjectTrack> late) {}

  private final EventFrame frame;
  private final OverlaySnapshots marks;
  private final List<Panel> panels = new ArrayList<>();

  /** How many of the pictures, the first ones, are of a clock that has ended. */
  private int ended;

  private long stepUs = FIRST_STEP_US;
  private final EventPacket piece = new EventPacket(4096);

  /** Time on the stream's clock at which its elapsed time would be 0. */
  private long baseUs = StreamNotification.NO_TIME_US;

  private long elapsedUs;
  private long panelElapsedUs;
  private long dueUs = FIRST_STEP_US;
  private long events;

  /** A sheet without pictures, over each of which the marks of a chain are drawn. */
  public ContactSheet(FilterChain chain) {
    frame = new EventFrame(chain.geometry());
    marks = new OverlaySnapshots(chain);
    for (Outlet<?> outlet : chain.outlets()) {
      if (outlet.type() == ObjectTrack.class) {
        outlet.subscribe(row -> take((ObjectTrack) row));
      }
    }
  }

  private void take(ObjectTrack row) {
    for (Panel panel : panels.subList(ended, panels.size())) {
      double aheadUs = panel.timeUs - row.timeUs();
      if (aheadUs >= 0 && aheadUs < Overlay.MAX_AHEAD_S * 1e6) {
        panel.late.put(row.id(), row);
      }
    }
  }

  @Override
  public void packet(EventPacket packet) {
    int from = 0;
    while (from < packet.size()) {
      if (baseUs == StreamNotification.NO_TIME_US) {
        baseUs = packet.firstTimeUs() - elapsedUs;
      }
      int due = packet.indexAtOrAfter(baseUs + dueUs, from);
      boolean whole = packet.lastTimeUs() - packet.timeUs(from) <= SHORT_US;
      int to = whole ? packet.size() : Math.min(packet.size(), due + 1);
      piece.clear();
      piece.append(packet, from, to);
      frame.packet(piece);
      elapsedUs = piece.lastTimeUs() - baseUs;
      events += to - from;
      from = to;
      if (elapsedUs >= dueUs) {
        add();
        if (panels.size() == CANDIDATES) {
          for (int i = CANDIDATES / 2 - 1; i >= 0; i--) {
            panels.remove(2 * i);
          }
          ended /= 2;
          stepUs *= 2;
        }
        dueUs = (elapsedUs / stepUs + 1) * stepUs;
      }
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    frame.notified(notification);
    if (notification.restartsTime()) {
      baseUs = StreamNotification.NO_TIME_US;
      ended = panels.size();
    }
  }

  private void add() {
    double spanUs = Math.max(1, elapsedUs - panelElapsedUs);
    double fadingUs = VISIBLE_SHARE * frame.geometry().pixels() * spanUs / Math.max(1, events);
    long constantUs = (long) Math.max(MIN_FADING_US, Math.min(MAX_FADING_US, fadingUs));
    int scale = Math.max(1, PANEL_PX / frame.geometry().width());
    FramePainter painter = new FramePainter(ColourMap.DARK, constantUs);
    BufferedImage picture = scaled(Pictures.draw(frame, painter, scale, none -> {}), PANEL_PX);
    panels.add(new Panel(picture, elapsedUs, frame.nowUs(), marks.marks(), new HashMap<>()));
    panelElapsedUs = elapsedUs;
    events = 0;
  }

  private void drawMarks(Panel panel) {
    OverlayCanvas canvas =
        Pictures.canvas(panel.picture, (double) PANEL_PX / frame.geometry().width(), true);
    panel.marks.forEach(layer -> layer.draw(panel.timeUs, canvas));
    for (ObjectTrack row : panel.late.values()) {
      double aheadS = Overlay.aheadS(row.timeUs(), panel.timeUs);
      double x = row.xPx() + aheadS * row.vxPxS();
      double y = row.yPx() + aheadS * row.vyPxS();
      MarkStyle style = MarkStyle.of(MarkStyle.Role.ESTIMATE, row.id());
      canvas.ellipse(x, y, row.majorPx(), row.minorPx(), row.angleRad(), style);
      canvas.text(x, y, Integer.toString(row.id()), MarkStyle.of(MarkStyle.Role.LABEL, row.id()));
    }
  }

  /**
   * The pictures with their times since the start, row by row; a stream that is too short for one
   * has a picture of its end, and one without events none.
   */
  public Optional<BufferedImage> draw() {
    if (panels.isEmpty() && events > 0) {
      add();
    }
    List<BufferedImage> pictures = new ArrayList<>();
    int distance = Math.max(1, (panels.size() + PANELS - 1) / PANELS);
    for (int i = (panels.size() - 1) % distance / 2; i < panels.size(); i += distance) {
      pictures.add(finished(panels.get(i)));
    }
    return pictures.isEmpty() ? Optional.empty() : Optional.of(join(pictures, PANEL_PX));
  }

  private BufferedImage finished(Panel panel) {
    drawMarks(panel);
    long minutes = panel.elapsedUs / 60_000_000L;
    String text =
        String.format(Locale.ROOT, "%d:%06.3f", minutes, panel.elapsedUs * 1e-6 - 60 * minutes);
    new PictureStamp(panel.picture, true).label(text);
    return panel.picture;
  }

  /**
   * Joins pictures of equal proportions, at least one, in rows of four, each of a width in pixels;
   * transparent between them.
   */
  public static BufferedImage join(List<BufferedImage> pictures, int widthPx) {
    int columns = Math.min(COLUMNS, pictures.size());
    List<BufferedImage> cells = pictures.stream().map(cell -> scaled(cell, widthPx)).toList();
    int highPx = cells.get(0).getHeight();
    BufferedImage sheet =
        new BufferedImage(
            columns * (widthPx + GAP_PX) - GAP_PX,
            (cells.size() + columns - 1) / columns * (highPx + GAP_PX) - GAP_PX,
            BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = sheet.createGraphics();
    for (int i = 0; i < cells.size(); i++) {
      graphics.drawImage(
          cells.get(i), i % columns * (widthPx + GAP_PX), i / columns * (highPx + GAP_PX), null);
    }
    graphics.dispose();
    return sheet;
  }

  private static BufferedImage scaled(BufferedImage picture, int widthPx) {
    if (picture.getWidth() == widthPx) {
      return picture;
    }
    int highPx =
        Math.max(1, Math.round((float) widthPx * picture.getHeight() / picture.getWidth()));
    BufferedImage scaled = new BufferedImage(widthPx, highPx, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = scaled.createGraphics();
    graphics.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    graphics.drawImage(picture, 0, 0, widthPx, highPx, null);
    graphics.dispose();
    return scaled;
  }
}
