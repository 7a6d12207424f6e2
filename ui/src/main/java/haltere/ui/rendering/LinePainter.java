package haltere.ui.rendering;

/**
 * Draws smooth lines and rings into opaque pixels, which are the size of those of the screen. Costs
 * by the pixels that are touched only, some nanoseconds each: where there is no graphics card a
 * toolkit's general shapes take many times as long.
 *
 * <p>Places are in pixels from the left top corner of the picture, 0.5 is the middle of the first.
 * What lies outside of the picture is left out. Thread rule: one thread at a time.
 */
final class LinePainter {
  /** Whatever is larger than this is no mark that anybody could see. */
  private static final double LONGEST = 1e6;

  private int[] pixels = new int[0];
  private int width;
  private int height;

  /** Draws into other pixels, row by row from the top. */
  void setTarget(int[] newPixels, int newWidth, int newHeight) {
    pixels = newPixels;
    width = newWidth;
    height = newHeight;
  }

  /**
   * A straight line.
   *
   * @param thickness in pixels
   * @param argb colour, not always opaque
   * @param round whether its ends are round; else they end where they end
   */
  void line(double x1, double y1, double x2, double y2, double thickness, int argb, boolean round) {
    double half = thickness / 2;
    double dx = x2 - x1;
    double dy = y2 - y1;
    double length = Math.sqrt(dx * dx + dy * dy);
    if (!(length < LONGEST) || isOutside(x1, y1, x2, y2, half + 1)) {
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
    boolean steep = Math.abs(dy) > Math.abs(dx);
    double reach = half + 1;
    // how far the line reaches across, on the axis that it is not mostly along
    double across = reach / (steep ? Math.abs(dy) : Math.abs(dx));
    double from = (steep ? Math.min(y1, y2) : Math.min(x1, x2)) - reach;
    double to = (steep ? Math.max(y1, y2) : Math.max(x1, x2)) + reach;
    int first = Math.max(0, (int) from);
    int last = Math.min((steep ? height : width) - 1, (int) to + 1);
    double slope = steep ? dx / dy : dy / dx;
    for (int along = first; along <= last; along++) {
      double middle = steep ? x1 + (along + 0.5 - y1) * slope : y1 + (along + 0.5 - x1) * slope;
      int low = Math.max(0, (int) (middle - across));
      int high = Math.min((steep ? width : height) - 1, (int) (middle + across));
      for (int beside = low; beside <= high; beside++) {
        double px = (steep ? beside : along) + 0.5 - x1;
        double py = (steep ? along : beside) + 0.5 - y1;
        double forward = px * dx + py * dy;
        double aside = Math.abs(px * dy - py * dx);
        double share = covered(aside, Math.max(-forward, forward - length), half, round);
        if (share > 0) {
          blend(steep ? along * width + beside : beside * width + along, argb, share);
        }
      }
    }
  }

  /** Share of a pixel that lies so far aside of a line and beyond its ends. */
  private static double covered(double aside, double beyond, double half, boolean round) {
    if (beyond <= 0) {
      return Math.min(1, half + 0.5 - aside);
    }
    return round
        ? Math.min(1, half + 0.5 - Math.sqrt(aside * aside + beyond * beyond))
        : Math.min(1, half + 0.5 - aside) * Math.max(0, 0.5 - beyond);
  }

  private boolean isOutside(double x1, double y1, double x2, double y2, double reach) {
    return Math.max(x1, x2) < -reach
        || Math.max(y1, y2) < -reach
        || Math.min(x1, x2) > width + reach
        || Math.min(y1, y2) > height + reach;
  }

  /**
   * A circle's outline.
   *
   * @param radius 0 for a dot
   * @param thickness in pixels
   */
  void ring(double x, double y, double radius, double thickness, int argb) {
    double half = thickness / 2;
    double outer = radius + half + 0.5;
    double inner = Math.max(0, radius - half - 0.5);
    if (!(outer < LONGEST)) {
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
      // where both halves meet no pixel is drawn twice
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

  /** A pixel, if it is there, with a colour of which a share is taken. */
  void dot(int column, int row, int argb, double share) {
    if (column >= 0 && row >= 0 && column < width && row < height) {
      blend(row * width + column, argb, share);
    }
  }

  private void blend(int index, int argb, double coverage) {
    int share = (int) ((argb >>> 24) * coverage * (256 / 255.0));
    int below = pixels[index];
    int redBlue = below & 0xFF00FF;
    int green = below & 0xFF00;
    redBlue += ((argb & 0xFF00FF) - redBlue) * share >> 8;
    green += ((argb & 0xFF00) - green) * share >> 8;
    pixels[index] = 0xFF000000 | redBlue & 0xFF00FF | green & 0xFF00;
  }
}
