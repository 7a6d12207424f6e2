package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.PixelArray;
import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.Arrays;

/**
 * One wing over the pixels: a dark sector about its hinge, whose two edges sweep over a list of
 * pixels sorted by their stroke angle. Each edge that passes a pixel changes its light at the very
 * time of the passage. The light sensitive part of a pixel is taken as a point at its centre (in a
 * DVS128 it is 8 % of the pixel's area).
 *
 * <p>The list is brought up to date when the body has moved by {@link #STALE_PX}; pixels over which
 * an edge goes by that motion are changed then.
 *
 * <p>Thread rule: one thread at a time.
 */
final class WingSweep {
  /** Motion of the fly, at the wing's tip, after which the pixels' angles are recomputed. */
  static final double STALE_PX = 0.05;

  /** Pixels nearer to the hinge than this never see the wing. */
  private static final double MIN_RADIUS_PX = 6;

  private static final double REBUILD_PX = 2;
  private static final int SHADOWS = 4096;

  // whether a pixel of the list can see the wing until the next list
  private static final byte ALWAYS = 0;
  private static final byte NEVER = 1;
  private static final byte DEPENDS = 2;

  private final int side;
  private final PixelArray pixels;
  private final WireMask wire;
  private final BodyShape shape;
  private final SeededRandom random;
  private final double[] shadows = new double[SHADOWS];
  private final long visibleBelow;
  private final double inner;
  private final double outer;
  private final double halfWidth;
  private final double minAngle;
  private final double maxAngle;
  private final int width;
  private final int height;

  // by pixel of the sensor
  private final boolean[] wasCovered;
  private final double[] shadow;

  // the list, in ascending order of angle; sorted[i] is an index into the columns below it
  private double[] angle = new double[0];
  private int[] sorted = new int[0];
  private long[] keys = new long[0];
  private int size;

  // by candidate: place about the hinge and angle in the pose of the list
  private int[] pixel = new int[0];
  private double[] dx = new double[0];
  private double[] dy = new double[0];
  private double[] listAngle = new double[0];
  private byte[] sight = new byte[0];
  private boolean[] visible = new boolean[0];
  private boolean[] covered = new boolean[0];
  private double listX;
  private double listY;
  private double listHeading;

  // the pose of the angles
  private double nowX = Double.NaN;
  private double nowY;
  private double nowHeading;

  private double low;
  private double high;
  private int firstCovered;
  private int afterCovered;

  WingSweep(
      int side,
      FlySceneSettings settings,
      FlyKinematics kinematics,
      PixelArray pixels,
      BodyShape shape,
      WireMask wire) {
    this.side = side;
    this.pixels = pixels;
    this.shape = shape;
    this.wire = wire;
    random = new SeededRandom(settings.run().seed(), "wing " + side);
    WingSettings wing = settings.fly().wing();
    for (int i = 0; i < SHADOWS; i++) {
      shadows[i] = wing.contrast() * StrictMath.exp(wing.contrastSpread() * random.gaussian());
    }
    visibleBelow = (long) (wing.visibleShare() * (1L << 32));
    outer = wing.lengthPx();
    inner = Math.max(MIN_RADIUS_PX, outer * wing.rootShare());
    halfWidth = wing.widthRad() / 2;
    minAngle = kinematics.minAngle(side);
    maxAngle = kinematics.maxAngle(side);
    width = settings.sensor().widthPx();
    height = settings.sensor().heightPx();
    wasCovered = new boolean[width * height];
    shadow = new double[width * height];
  }

  /** Puts the wing at an angle without events: where it is when the scene begins. */
  void place(FlyPose pose, double strokeAngle) {
    low = strokeAngle - halfWidth;
    high = strokeAngle + halfWidth;
    build(pose);
    follow(pose, 0);
  }

  /**
   * Applies the motion of the body.
   *
   * @param pose of the body now
   * @param timeUs now
   */
  void bodyMoved(FlyPose pose, double timeUs) {
    double moved =
        Math.abs(pose.hingeX[side] - nowX)
            + Math.abs(pose.hingeY[side] - nowY)
            + Math.abs(pose.heading - nowHeading) * outer;
    if (moved < STALE_PX) {
      return;
    }
    follow(pose, timeUs);
    double fromList =
        Math.abs(pose.hingeX[side] - listX)
            + Math.abs(pose.hingeY[side] - listY)
            + Math.abs(pose.heading - listHeading) * outer;
    if (fromList > REBUILD_PX) {
      build(pose);
      follow(pose, timeUs);
    }
  }

  /**
   * Moves the wing from its last position, at constant angular velocity.
   *
   * @param strokeAngle at the end
   * @param fromUs time at its last position
   * @param toUs time at the end
   */
  void sweepTo(double strokeAngle, double fromUs, double toUs) {
    double newLow = strokeAngle - halfWidth;
    double newHigh = strokeAngle + halfWidth;
    double moved = newHigh - high;
    double usPerRad = moved == 0 ? 0 : (toUs - fromUs) / moved;
    if (moved > 0) {
      while (afterCovered < size && angle[afterCovered] < newHigh) {
        enter(sorted[afterCovered], fromUs + (angle[afterCovered] - high) * usPerRad);
        afterCovered++;
      }
      while (firstCovered < size && angle[firstCovered] < newLow) {
        leave(sorted[firstCovered], fromUs + (angle[firstCovered] - low) * usPerRad);
        firstCovered++;
      }
    } else if (moved < 0) {
      while (firstCovered > 0 && angle[firstCovered - 1] >= newLow) {
        firstCovered--;
        enter(sorted[firstCovered], fromUs + (angle[firstCovered] - low) * usPerRad);
      }
      while (afterCovered > 0 && angle[afterCovered - 1] >= newHigh) {
        afterCovered--;
        leave(sorted[afterCovered], fromUs + (angle[afterCovered] - high) * usPerRad);
      }
    }
    low = newLow;
    high = newHigh;
  }

  private void enter(int candidate, double timeUs) {
    if (!visible[candidate]) {
      return;
    }
    int p = pixel[candidate];
    covered[candidate] = true;
    long draw = random.nextLong();
    if (draw >>> 32 < visibleBelow) {
      shadow[p] = shadows[(int) draw & (SHADOWS - 1)];
      pixels.change(p, timeUs, -shadow[p]);
    }
  }

  private void leave(int candidate, double timeUs) {
    int p = pixel[candidate];
    covered[candidate] = false;
    if (shadow[p] != 0) {
      pixels.change(p, timeUs, shadow[p]);
      shadow[p] = 0;
    }
  }

  /** Lists the pixels around the wing, with a margin for the motion until the next time. */
  private void build(FlyPose pose) {
    for (int i = 0; i < size; i++) {
      wasCovered[pixel[i]] = covered[i];
    }
    listX = pose.hingeX[side];
    listY = pose.hingeY[side];
    listHeading = pose.heading;
    double margin = REBUILD_PX + 1;
    int fromX = (int) Math.max(0, Math.floor(listX - outer - margin));
    int toX = (int) Math.min(width - 1, Math.ceil(listX + outer + margin));
    int fromY = (int) Math.max(0, Math.floor(listY - outer - margin));
    int toY = (int) Math.min(height - 1, Math.ceil(listY + outer + margin));
    int capacity = Math.max(0, toX - fromX + 1) * Math.max(0, toY - fromY + 1);
    if (capacity > pixel.length) {
      allocate(capacity + capacity / 8);
    }
    size = 0;
    for (int y = fromY; y <= toY; y++) {
      for (int x = fromX; x <= toX; x++) {
        double px = x - listX;
        double py = y - listY;
        double r = Math.sqrt(px * px + py * py);
        if (r > inner - margin && r < outer + margin && !wire.hides(y * width + x)) {
          double a = strokeAngle(StrictMath.atan2(py, px), pose.heading);
          double slack = halfWidth + margin / r;
          if (a > minAngle - slack && a < maxAngle + slack) {
            keys[size++] = (long) ((a + 2) * (1 << 28)) << 32 | (y * width + x);
          }
        }
      }
    }
    // in order of angle, so that loops over the list run through memory in order
    Arrays.sort(keys, 0, size);
    for (int i = 0; i < size; i++) {
      int p = (int) keys[i];
      int x = p % width;
      int y = p / width;
      pixel[i] = p;
      dx[i] = x - listX;
      dy[i] = y - listY;
      listAngle[i] = strokeAngle(StrictMath.atan2(dy[i], dx[i]), pose.heading);
      sorted[i] = i;
      sight[i] = sight(pose, x, y, Math.sqrt(dx[i] * dx[i] + dy[i] * dy[i]), margin);
      covered[i] = wasCovered[p];
    }
    Arrays.fill(wasCovered, false);
  }

  private byte sight(FlyPose pose, int x, int y, double radius, double margin) {
    double fromBody = shape.distance(pose, x, y);
    double fromRim = Math.min(radius - inner, outer - radius);
    if (Math.min(fromBody, fromRim) < -margin) {
      return NEVER;
    }
    return Math.min(fromBody, fromRim) > margin ? ALWAYS : DEPENDS;
  }

  private void allocate(int capacity) {
    keys = new long[capacity];
    angle = new double[capacity];
    sorted = new int[capacity];
    pixel = new int[capacity];
    dx = new double[capacity];
    dy = new double[capacity];
    listAngle = new double[capacity];
    sight = new byte[capacity];
    visible = new boolean[capacity];
    covered = new boolean[capacity];
  }

  /** Stroke angle in [-pi / 2, 3 pi / 2) of a direction on the sensor. */
  private double strokeAngle(double direction, double heading) {
    double turned = side == FlyKinematics.LEFT ? direction - heading : heading - direction;
    double shifted = (turned + Math.PI / 2) / (2 * Math.PI);
    return (shifted - Math.floor(shifted)) * 2 * Math.PI - Math.PI / 2;
  }

  /** Computes the angles in a pose from those in the list's, by the small turn between them. */
  private void follow(FlyPose pose, double timeUs) {
    nowX = pose.hingeX[side];
    nowY = pose.hingeY[side];
    nowHeading = pose.heading;
    double shiftX = nowX - listX;
    double shiftY = nowY - listY;
    double sign = side == FlyKinematics.LEFT ? 1 : -1;
    for (int i = 0; i < size; i++) {
      int c = sorted[i];
      double px = dx[c] - shiftX;
      double py = dy[c] - shiftY;
      double dot = dx[c] * px + dy[c] * py;
      double q = (dx[c] * py - dy[c] * px) / dot;
      double turn = q * (1 - q * q * (1.0 / 3 - q * q * 0.2));
      angle[i] = listAngle[c] + sign * (turn - (nowHeading - listHeading));
      visible[c] =
          sight[c] == ALWAYS
              || sight[c] == DEPENDS
                  && isOnWing(px * px + py * py)
                  && !shape.covers(pose, nowX + px, nowY + py);
    }
    sortFinely();
    firstCovered = countBelow(low);
    afterCovered = countBelow(high);
    for (int i = 0; i < size; i++) {
      int c = sorted[i];
      boolean isUnder = visible[c] && i >= firstCovered && i < afterCovered;
      if (isUnder != covered[c]) {
        double eventUs = Math.max(timeUs, pixels.computedUntilUs(pixel[c]));
        if (isUnder) {
          enter(c, eventUs);
        } else {
          leave(c, eventUs);
        }
      }
    }
  }

  private boolean isOnWing(double squareOfRadius) {
    return squareOfRadius >= inner * inner && squareOfRadius <= outer * outer;
  }

  /** Insertion sort: the list is in order except for a few neighbours. */
  private void sortFinely() {
    for (int i = 1; i < size; i++) {
      double a = angle[i];
      if (angle[i - 1] > a) {
        int c = sorted[i];
        int j = i;
        while (j > 0 && angle[j - 1] > a) {
          angle[j] = angle[j - 1];
          sorted[j] = sorted[j - 1];
          j--;
        }
        angle[j] = a;
        sorted[j] = c;
      }
    }
  }

  private int countBelow(double border) {
    int from = 0;
    int to = size;
    while (from < to) {
      int middle = (from + to) >>> 1;
      if (angle[middle] < border) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from;
  }
}
