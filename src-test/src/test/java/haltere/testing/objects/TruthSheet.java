package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.ContactSheet;
import haltere.ui.rendering.EventFrame;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.Pictures;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;

/**
 * A picture of a scene at several moments: events, boxes of truth with their identities, ignored
 * regions, and tracks with theirs. Thread rule: one thread at a time.
 */
final class TruthSheet implements StreamHandler {
  private static final int PANELS = 8;
  private static final int PANEL_PX = 420;
  private static final long FADING_US = 15_000;

  private final List<TruthMoment> moments = new ArrayList<>();
  private final List<BufferedImage> panels = new ArrayList<>();
  private final NavigableMap<Long, List<TrackRow>> ticks;
  private final EventFrame frame;
  private final Rectangle shown;
  private final int scale;

  private TruthSheet(ObjectScene scene, List<TrackRow> rows, EventSource events) {
    ticks = TrackTable.byTime(rows);
    frame = new EventFrame(events.geometry());
    shown = shown(scene, events.geometry());
    scale = Math.max(1, Math.round((float) PANEL_PX / shown.width));
    int n = scene.truth().size();
    for (int i = 0; i < PANELS; i++) {
      moments.add(scene.truth().get((int) ((i + 0.5) * n / PANELS)));
    }
  }

  /** The part of the picture in which objects are, in rows from the top. */
  private static Rectangle shown(ObjectScene scene, SensorGeometry sensor) {
    Rectangle objects = new Rectangle(-1, -1);
    for (TruthMoment moment : scene.truth()) {
      for (TrueObject object : moment.objects()) {
        Box box = object.box();
        objects.add((int) box.x0(), sensor.height() - (int) box.y0());
        objects.add((int) box.x1(), sensor.height() - (int) box.y1());
      }
    }
    int margin = 10 + Math.max(objects.width, objects.height) / 5;
    objects.grow(margin, margin);
    return objects.intersection(new Rectangle(sensor.width(), sensor.height()));
  }

  /** Draws a scene into a file of its name. */
  static void draw(ObjectScene scene, List<TrackRow> rows, Path folder) throws IOException {
    try (EventSource events = scene.events().open()) {
      TruthSheet sheet = new TruthSheet(scene, rows, events);
      events.drainTo(sheet);
      Pictures.write(
          folder.resolve(scene.name() + ".png"), ContactSheet.join(sheet.panels, PANEL_PX));
    }
  }

  @Override
  public void packet(EventPacket packet) {
    int from = 0;
    while (panels.size() < PANELS
        && !packet.isEmpty()
        && packet.lastTimeUs() >= moments.get(panels.size()).timeUs()) {
      int to = packet.indexAtOrAfter(moments.get(panels.size()).timeUs());
      show(packet, from, to);
      panels.add(panel(moments.get(panels.size())));
      from = to;
    }
    show(packet, from, packet.size());
  }

  private void show(EventPacket packet, int from, int to) {
    EventPacket part = new EventPacket(to - from);
    part.append(packet, from, to);
    frame.packet(part);
  }

  @Override
  public void notified(StreamNotification notification) {
    frame.notified(notification);
  }

  private BufferedImage panel(TruthMoment moment) {
    return Pictures.draw(
            frame,
            new FramePainter(ColourMap.DARK, FADING_US),
            scale,
            canvas -> draw(canvas, moment))
        .getSubimage(shown.x * scale, shown.y * scale, shown.width * scale, shown.height * scale);
  }

  private void draw(OverlayCanvas canvas, TruthMoment moment) {
    moment.ignored().forEach(box -> draw(canvas, box, MarkStyle.of(Role.PATH)));
    for (TrueObject object : moment.objects()) {
      draw(canvas, object.box(), MarkStyle.of(Role.REGION));
      canvas.text(
          object.box().x1(), object.box().y1(), "" + object.id(), MarkStyle.of(Role.REGION));
    }
    TrackTable.at(ticks, moment.timeUs()).forEach(row -> draw(canvas, row));
  }

  private static void draw(OverlayCanvas canvas, Box box, MarkStyle style) {
    canvas.rectangle(box.x0(), box.y0(), box.width(), box.height(), style);
  }

  private static void draw(OverlayCanvas canvas, TrackRow row) {
    MarkStyle style = MarkStyle.of(Role.OBJECT, row.id());
    if (Double.isNaN(row.majorPx() + row.minorPx() + row.angleRad())) {
      canvas.circle(row.xPx(), row.yPx(), Matching.MARGIN_PX, style);
    } else {
      canvas.ellipse(row.xPx(), row.yPx(), row.majorPx(), row.minorPx(), row.angleRad(), style);
    }
    canvas.text(row.xPx(), row.yPx(), "" + row.id(), style);
  }
}
