package haltere.ui.rendering;

/**
 * Draws antialiased lines and rings into screen pixels; pixels that are not opaque are
 * premultiplied. The cost is some nanoseconds for each touched pixel, much less than that of a
 * toolkit's shapes without a graphics card.
 *
 * <p>Places are in pixels from the left top corner of the picture, 0.5 is the middle of the first.
 * What lies outside of the picture is left out.
 */
public final class LinePainter {
  /** Whatever is larger than this is no mark that anybody could see. */
  private static final double MAX_LENGTH_PX = 1e6;

  private int[] pixels = new int[0];
  private int width;
  private int height;

  /** Draws into other pixels, row by row from the top. */
  public void setTarget(int[] newPixels, int newWidth, int newHeight) {
    pixels = newPixels;
    width = newWidth;
    height = newHeight;
  }

  /**
   * A straight line between two positions, of a thickness in pixels and a colour that may be
   * translucent; its ends are round or flat.
   */
  public void line(
      double x1, double y1, double x2, double y2, double thickness, int argb, boolean round) {
    double half = thickness / 2;
    double dx = x2 - x1;
    double dy = y2 - y1;
    double length = Math.sqrt(dx * dx + dy * dy);
    if (!(length < MAX_LENGTH_PX) || isOutside(x1, y1, x2, y2, half + 1)) {
      return;
    }
    if (length < 1e-9) {
      if (round) {
        ring(x1, y1, 0, thickness, argb);
      }
      return;
    }
    dx /= length;
    dy /= length;
    if (Math.abs(dy) > Math.abs(dx)) {
      stroke(y1, x1, dy, dx, length, half, argb, round, height, width, width, 1);
    } else {
      stroke(x1, y1, dx, dy, length, half, argb, round, width, height, 1, width);
    }
  }

  /**
   * A line that is mostly along the first of two axes (a), on which its direction of length 1 is
   * da. Limits are the pixels on each axis, steps those from a pixel to the next.
   */
  private void stroke(
      double a1,
      double b1,
      double da,
      double db,
      double length,
      double half,
      int argb,
      boolean round,
      int limitA,
      int limitB,
      int stepA,
      int stepB) {
    double reach = half + 0.5;
    // extent of the line along the second axis
    double across = reach / Math.abs(da);
    double slope = db / da;
    double a2 = a1 + length * da;
    int first = Math.max(0, (int) (Math.min(a1, a2) - reach));
    int last = Math.min(limitA - 1, (int) (Math.max(a1, a2) + reach));
    for (int along = first; along <= last; along++) {
      double pa = along + 0.5 - a1;
      double middle = b1 + pa * slope;
      int low = Math.max(0, (int) Math.ceil(middle - across - 0.5));
      int high = Math.min(limitB - 1, (int) Math.floor(middle + across - 0.5));
      double forward = pa * da + (low + 0.5 - b1) * db;
      double lateral = pa * db - (low + 0.5 - b1) * da;
      int index = along * stepA + low * stepB;
      for (int beside = low; beside <= high; beside++) {
        double beyond = Math.max(-forward, forward - length);
        double share = Math.min(1, reach - Math.abs(lateral));
        if (beyond > 0) {
          share =
              round
                  ? Math.min(1, reach - Math.sqrt(lateral * lateral + beyond * beyond))
                  : share * (0.5 - beyond);
        }
        if (share > 0) {
          blend(index, argb, share);
        }
        forward += db;
        lateral -= da;
        index += stepB;
      }
    }
  }

  private boolean isOutside(double x1, double y1, double x2, double y2, double reach) {
    return Math.max(x1, x2) < -reach
        || Math.max(y1, y2) < -reach
        || Math.min(x1, x2) > width + reach
        || Math.min(y1, y2) > height + reach;
  }

  /** A circle of a thickness in pixels; a dot for radius 0. */
  void ring(double x, double y, double radius, double thickness, int argb) {
    double half = thickness / 2;
    double outer = radius + half + 0.5;
    double inner = Math.max(0, radius - half - 0.5);
    if (!(outer < MAX_LENGTH_PX)) {
      return;
    }
    int first = Math.max(0, (int) Math.floor(y - outer));
    int last = Math.min(height - 1, (int) Math.ceil(y + outer));
    for (int row = first; row <= last; row++) {
      double dy = row + 0.5 - y;
      if (Math.abs(dy) >= outer) {
        continue;
      }
      double far = Math.sqrt(outer * outer - dy * dy);
      double near = Math.abs(dy) < inner ? Math.sqrt(inner * inner - dy * dy) : 0;
      int leftTo = (int) Math.floor(x - near);
      arc(row, (int) Math.floor(x - far), leftTo, x, dy, radius, half, argb);
      // no pixel is drawn twice where both halves meet
      int rightFrom = Math.max(leftTo + 1, (int) Math.floor(x + near));
      arc(row, rightFrom, (int) Math.ceil(x + far), x, dy, radius, half, argb);
    }
  }

  private void arc(
      int row, int from, int to, double x, double dy, double radius, double half, int argb) {
    for (int column = Math.max(0, from); column <= Math.min(width - 1, to); column++) {
      double dx = column + 0.5 - x;
      double distance = Math.sqrt(dx * dx + dy * dy);
      double coverage = Math.min(1, half + 0.5 - Math.abs(distance - radius));
      if (coverage > 0) {
        blend(row * width + column, argb, coverage);
      }
    }
  }

  /** A filled rectangle; its edges are those of pixels. */
  void fill(int left, int top, int right, int bottom, int argb) {
    for (int row = Math.max(0, top); row < Math.min(height, bottom); row++) {
      for (int column = Math.max(0, left); column < Math.min(width, right); column++) {
        blend(row * width + column, argb, 1);
      }
    }
  }

  /** Blends a colour into a pixel by a share, if the pixel exists. */
  void dot(int column, int row, int argb, double share) {
    if (column >= 0 && row >= 0 && column < width && row < height) {
      blend(row * width + column, argb, share);
    }
  }

  private void blend(int index, int argb, double coverage) {
    int share = (int) ((argb >>> 24) * coverage * (256 / 255.0));
    int below = pixels[index];
    int alpha = below >>> 24;
    int redBlue = below & 0xFF00FF;
    int green = below & 0xFF00;
    alpha += (255 - alpha) * share >> 8;
    redBlue += ((argb & 0xFF00FF) - redBlue) * share >> 8;
    green += ((argb & 0xFF00) - green) * share >> 8;
    pixels[index] = alpha << 24 | redBlue & 0xFF00FF | green & 0xFF00;
  }
}
