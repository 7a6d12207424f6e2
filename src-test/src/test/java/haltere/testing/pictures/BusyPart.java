package haltere.testing.pictures;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.awt.image.BufferedImage;

/**
 * The part of a sensor in which nearly all of a recording's events are, and how large to draw it:
 * on a large sensor what moves is often small. Thread rule: not safe for use by two threads at a
 * time.
 */
final class BusyPart {
  /** Share of the events that may lie beyond each side. */
  private static final double BEYOND = 0.02;

  /** What is left around them, as a share of the sensor's longer side. */
  private static final double MARGIN = 0.08;

  private final SensorGeometry geometry;
  private final long[] columns;
  private final long[] rows;
  private long events;
  private int left;
  private int right;
  private int bottom;
  private int top;

  BusyPart(SensorGeometry geometry) {
    this.geometry = geometry;
    columns = new long[geometry.width()];
    rows = new long[geometry.height()];
  }

  void add(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      columns[packet.x(i)]++;
      rows[packet.y(i)]++;
    }
    events += packet.size();
  }

  long events() {
    return events;
  }

  /** All events are known. */
  void settle() {
    int margin = (int) (MARGIN * geometry.longerSide());
    left = Math.max(0, reached(columns, BEYOND) - margin);
    right = Math.min(columns.length - 1, reached(columns, 1 - BEYOND) + margin);
    bottom = Math.max(0, reached(rows, BEYOND) - margin);
    top = Math.min(rows.length - 1, reached(rows, 1 - BEYOND) + margin);
  }

  /** The first place up to which there is this share of the events. */
  private int reached(long[] counts, double share) {
    long sum = 0;
    int place = 0;
    while (place < counts.length - 1 && sum + counts[place] < share * events) {
      sum += counts[place++];
    }
    return place;
  }

  /** Pixels of a picture for one of the sensor, where its longer side is to be about this long. */
  int scale(int sidePx) {
    return Math.max(1, Math.round((float) sidePx / Math.max(right - left + 1, top - bottom + 1)));
  }

  /** Cuts it out of a picture of the whole sensor. */
  BufferedImage cut(BufferedImage whole, int scale) {
    return whole.getSubimage(
        left * scale,
        (geometry.height() - 1 - top) * scale,
        (right - left + 1) * scale,
        (top - bottom + 1) * scale);
  }
}
