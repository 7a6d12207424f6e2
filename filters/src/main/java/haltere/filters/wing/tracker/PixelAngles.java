package haltere.filters.wing.tracker;

import haltere.filters.wing.internal.stroke.StrokeFrame;
import java.util.Arrays;

/** Cached side and stroke angle of each pixel, for a fly that does not move. */
final class PixelAngles {
  private static final float UNKNOWN = 0;

  private final int width;
  private final FlyPosition position;

  // 1 + angle in [0, 2 pi) on the left, -1 - angle on the right, NaN outside the region of interest
  private final float[] codes;

  PixelAngles(int width, int height, FlyPosition position) {
    this.width = width;
    this.position = position;
    codes = new float[width * height];
  }

  /** Clears the cache: the fly has moved. */
  void clear() {
    Arrays.fill(codes, UNKNOWN);
  }

  /** Code of a pixel, NaN if it is outside the region of interest. */
  float code(int x, int y) {
    float code = codes[y * width + x];
    return code == UNKNOWN ? workOut(x, y) : code;
  }

  private float workOut(int x, int y) {
    int side = position.side(x, y);
    StrokeFrame frame = position.frames[side];
    float code = Float.NaN;
    if (frame.look(x, y)) {
      double angle = frame.angle();
      float from = (float) (1 + (angle < 0 ? angle + 2 * Math.PI : angle));
      code = side == 0 ? from : -from;
    }
    codes[y * width + x] = code;
    return code;
  }

  /** Side of a code, 0 left, 1 right; undefined for NaN. */
  static int side(float code) {
    return Float.floatToRawIntBits(code) >>> 31;
  }

  /** Stroke angle of a code that is not NaN, in [0, 2 pi), within 3e-7 radians. */
  static double angle(float code) {
    return Math.abs(code) - 1;
  }
}
