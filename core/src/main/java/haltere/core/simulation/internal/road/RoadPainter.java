package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.road.PaintedBox.Ray;
import haltere.core.simulation.internal.sensor.PixelArray;
import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.ArrayList;
import java.util.List;

/**
 * Renders the traffic onto the pixels, interval by interval. In an interval, each vehicle is
 * rendered so often that it moves by at most half a pixel in between, or a 24th of its size, less
 * than any painted detail. Rendering determines the light of each pixel of the vehicle's box, that
 * of the nearest part along its ray. Where the light has changed, bisection finds the time of the
 * change within a sixteenth of a pixel's motion; the time is drawn at random in that range.
 *
 * <p>Thread rule: one thread at a time.
 */
final class RoadPainter {
  /** Inverse of the tangent of a column that sees straight ahead. */
  static final double STEEP = 1e12;

  private static final double US = 1e-6;
  private static final int MAX_SAMPLES = 64;
  private static final double MIN_MOTION_PX = 0.5;
  private static final double MAX_MOTION_PX = 8;
  private static final double MOTION_SHARE = 1.0 / 24;
  private static final double TIMED_WITHIN_PX = 1.0 / 16;

  /** A vehicle in an interval. */
  private static final class Mover {
    Vehicle vehicle;
    boolean isGone;
    boolean isFollowed;
    double fromX;
    double fromNear;
    double byX;
    double byNear;
    RoadView before = new RoadView();
    RoadView after = new RoadView();
    int samples;
    int halvings;
    int firstColumn;
    int lastColumn;
    int firstRow;
    int lastRow;
  }

  /** A part of a vehicle in a row. */
  private static final class Slice {
    PaintedBox part;
    double middle;
    double near;
    double enter;
    double leave;
  }

  private final RoadCamera camera;
  private final TrafficPlan plan;
  private final PixelArray pixels;
  private final SeededRandom random;
  private final int width;
  private final int height;
  private final Ray ray;
  private final double[] tangent;
  private final double[] inverseTangent;
  private final double[] inverseCos;
  private final double[] inverseSin;
  private final int rows;
  private final double[] shown;
  private final double[] lookedUs;
  private final List<Vehicle> there = new ArrayList<>();
  private final List<Mover> movers = new ArrayList<>();
  private final List<Mover> spare = new ArrayList<>();
  private final List<Mover> candidates = new ArrayList<>();
  private final List<Slice> slices = new ArrayList<>();
  private int slicesInRow;

  RoadPainter(RoadSceneSettings settings, RoadCamera camera, TrafficPlan plan, PixelArray pixels) {
    this.camera = camera;
    this.plan = plan;
    this.pixels = pixels;
    random = new SeededRandom(settings.run().seed(), "edges");
    width = settings.sensor().widthPx();
    height = settings.sensor().heightPx();
    ray = new Ray(camera.heightM);
    tangent = new double[width];
    inverseTangent = new double[width];
    for (int x = 0; x < width; x++) {
      tangent[x] = camera.tangent(x);
      inverseTangent[x] = tangent[x] == 0 ? STEEP : 1 / tangent[x];
    }
    inverseCos = new double[height];
    inverseSin = new double[height];
    int below = 0;
    for (int y = 0; y < height && camera.angle(y) > 0; y++) {
      inverseCos[y] = 1 / StrictMath.cos(camera.angle(y));
      inverseSin[y] = 1 / StrictMath.sin(camera.angle(y));
      below++;
    }
    rows = below;
    shown = new double[width * height];
    lookedUs = new double[width * height];
  }

  /** Renders the initial traffic, without events. */
  void begin() {
    follow(0);
    for (int i = 0; i < movers.size(); i++) {
      Mover mover = movers.get(i);
      place(mover, 0, 0);
      seek(mover);
    }
    for (int i = 0; i < movers.size(); i++) {
      Mover mover = movers.get(i);
      gather(mover);
      for (int y = mover.firstRow; y <= mover.lastRow; y++) {
        for (int x = mover.firstColumn; x <= mover.lastColumn; x++) {
          shown[y * width + x] = light(x, y, 0);
          pixels.settle(y * width + x, shown[y * width + x]);
        }
      }
    }
  }

  /** Renders an interval, microseconds since the beginning. */
  void paint(double fromUs, double toUs) {
    follow(toUs * US);
    int max = 1;
    for (int i = 0; i < movers.size(); i++) {
      Mover mover = movers.get(i);
      place(mover, fromUs * US, toUs * US);
      seek(mover);
      max = Math.max(max, mover.samples);
    }
    for (int step = 1; step <= max; step++) {
      for (int i = 0; i < movers.size(); i++) {
        Mover mover = movers.get(i);
        if (mover.samples > 0 && step % (max / mover.samples) == 0) {
          sampleBrightness(mover, (double) step / max, fromUs, toUs);
        }
      }
    }
    for (int i = movers.size() - 1; i >= 0; i--) {
      if (movers.get(i).isGone) {
        spare.add(movers.remove(i));
      }
    }
  }

  /** Updates the list of movers; those that have left are rendered once more. */
  private void follow(double seconds) {
    there.clear();
    plan.collect(seconds, there);
    for (int i = 0; i < movers.size(); i++) {
      Mover mover = movers.get(i);
      mover.isGone = true;
      for (int j = 0; j < there.size(); j++) {
        if (there.get(j).id == mover.vehicle.id) {
          mover.isGone = false;
          there.remove(j);
          break;
        }
      }
    }
    for (int i = 0; i < there.size(); i++) {
      Mover mover = spare.isEmpty() ? new Mover() : spare.remove(spare.size() - 1);
      mover.vehicle = there.get(i);
      mover.isGone = false;
      mover.isFollowed = false;
      movers.add(mover);
    }
  }

  private void place(Mover mover, double fromS, double toS) {
    Vehicle vehicle = mover.vehicle;
    mover.fromX = vehicle.x(fromS);
    mover.fromNear = vehicle.near(fromS);
    double toX = vehicle.x(toS);
    double toNear = vehicle.near(toS);
    mover.byX = toX - mover.fromX;
    mover.byNear = toNear - mover.fromNear;
    RoadView before = mover.before;
    mover.before = mover.after;
    mover.after = before;
    if (!mover.isFollowed) {
      mover.before.see(camera, vehicle, mover.fromX, mover.fromNear);
      mover.isFollowed = true;
    }
    mover.after.see(camera, vehicle, toX, toNear);
  }

  private void seek(Mover mover) {
    RoadView a = mover.before;
    RoadView b = mover.after;
    mover.firstColumn = (int) Math.max(0, Math.floor(Math.min(a.fromX, b.fromX)));
    mover.lastColumn = (int) Math.min(width - 1, Math.ceil(Math.max(a.toX, b.toX)));
    mover.firstRow = (int) Math.max(0, Math.floor(Math.min(a.fromY, b.fromY)));
    mover.lastRow = (int) Math.min(rows - 1, Math.ceil(Math.max(a.toY, b.toY)));
    double motion = motion(a, b, Double.POSITIVE_INFINITY);
    double seen = Math.max(motion(a, b, 1), Math.min(motion, 2 * MAX_MOTION_PX));
    double size = Math.min(b.toX - b.fromX, b.toY - b.fromY);
    double max = Math.max(MIN_MOTION_PX, Math.min(MAX_MOTION_PX, size * MOTION_SHARE));
    mover.samples = motion == 0 && !mover.isGone ? 0 : 1;
    while (mover.samples > 0 && mover.samples < MAX_SAMPLES && seen > max * mover.samples) {
      mover.samples *= 2;
    }
    mover.halvings = 0;
    for (double px = motion / Math.max(1, mover.samples); px > TIMED_WITHIN_PX; px /= 2) {
      mover.halvings++;
    }
    if (mover.firstColumn > mover.lastColumn || mover.firstRow > mover.lastRow) {
      mover.samples = 0;
    }
  }

  /** Largest motion of a side of a box on the sensor and a margin around it. */
  private double motion(RoadView a, RoadView b, double margin) {
    double along = Math.max(way(a.fromX, b.fromX, width, margin), way(a.toX, b.toX, width, margin));
    double up = Math.max(way(a.fromY, b.fromY, height, margin), way(a.toY, b.toY, height, margin));
    return Math.max(along, up);
  }

  private static double way(double from, double to, int size, double margin) {
    double a = Math.max(-margin, Math.min(size + margin, from));
    double b = Math.max(-margin, Math.min(size + margin, to));
    return Math.abs(b - a);
  }

  private void gather(Mover mover) {
    candidates.clear();
    for (int i = 0; i < movers.size(); i++) {
      Mover other = movers.get(i);
      if (!other.isGone
          && other.firstColumn <= mover.lastColumn
          && other.lastColumn >= mover.firstColumn
          && other.firstRow <= mover.lastRow
          && other.lastRow >= mover.firstRow) {
        candidates.add(other);
      }
    }
  }

  private void sampleBrightness(Mover mover, double share, double fromUs, double toUs) {
    gather(mover);
    double spanUs = toUs - fromUs;
    double nowUs = fromUs + share * spanUs;
    double lastUs = nowUs - spanUs / mover.samples;
    for (int y = mover.firstRow; y <= mover.lastRow; y++) {
      slice(y, share);
      for (int x = mover.firstColumn; x <= mover.lastColumn; x++) {
        int pixel = y * width + x;
        double light = lightInSlice(x);
        if (light != shown[pixel]) {
          double low = Math.max(lastUs, lookedUs[pixel]);
          double high = nowUs;
          for (int i = 0; i < mover.halvings; i++) {
            double middle = (low + high) / 2;
            if (light(x, y, (middle - fromUs) / spanUs) == shown[pixel]) {
              low = middle;
            } else {
              high = middle;
            }
          }
          pixels.change(pixel, random.between(low, high), light - shown[pixel]);
          shown[pixel] = light;
        }
        lookedUs[pixel] = nowUs;
      }
    }
  }

  /** Prepares a row: the parts that it meets and the values that do not depend on the column. */
  private void slice(int y, double share) {
    ray.inverseCos = inverseCos[y];
    ray.inverseSin = inverseSin[y];
    slicesInRow = 0;
    for (int i = 0; i < candidates.size(); i++) {
      Mover mover = candidates.get(i);
      if (y < mover.firstRow || y > mover.lastRow) {
        continue;
      }
      double middle = mover.fromX + share * mover.byX;
      double near = mover.fromNear + share * mover.byNear;
      List<PaintedBox> parts = mover.vehicle.parts;
      for (int p = 0; p < parts.size(); p++) {
        if (slicesInRow == slices.size()) {
          slices.add(new Slice());
        }
        Slice slice = slices.get(slicesInRow);
        slice.part = parts.get(p);
        slice.middle = middle;
        slice.near = near;
        slice.enter = slice.part.enter(near, ray);
        slice.leave = slice.part.leave(near, ray);
        slicesInRow += slice.enter <= slice.leave ? 1 : 0;
      }
    }
  }

  /** Light of a pixel of the prepared row. */
  private double lightInSlice(int x) {
    ray.tangent = tangent[x];
    ray.inverseTangent = inverseTangent[x];
    double nearest = PaintedBox.NOWHERE;
    Slice hit = null;
    for (int i = 0; i < slicesInRow; i++) {
      Slice slice = slices.get(i);
      double range = slice.part.intersectAcross(slice.middle, slice.enter, slice.leave, ray);
      if (range < nearest) {
        nearest = range;
        hit = slice;
      }
    }
    return hit == null ? 0 : hit.part.lightAt(hit.middle, hit.near, ray, nearest);
  }

  /** Light of a pixel at a fraction of the interval. */
  private double light(int x, int y, double share) {
    ray.tangent = tangent[x];
    ray.inverseTangent = inverseTangent[x];
    ray.inverseCos = inverseCos[y];
    ray.inverseSin = inverseSin[y];
    double nearest = PaintedBox.NOWHERE;
    PaintedBox hit = null;
    double hitX = 0;
    double hitNear = 0;
    for (int i = 0; i < candidates.size(); i++) {
      Mover mover = candidates.get(i);
      if (x < mover.firstColumn
          || x > mover.lastColumn
          || y < mover.firstRow
          || y > mover.lastRow) {
        continue;
      }
      double middle = mover.fromX + share * mover.byX;
      double near = mover.fromNear + share * mover.byNear;
      List<PaintedBox> parts = mover.vehicle.parts;
      for (int p = 0; p < parts.size(); p++) {
        PaintedBox part = parts.get(p);
        double range = part.intersect(middle, near, ray);
        if (range < nearest) {
          nearest = range;
          hit = part;
          hitX = middle;
          hitNear = near;
        }
      }
    }
    return hit == null ? 0 : hit.lightAt(hitX, hitNear, ray, nearest);
  }
}
