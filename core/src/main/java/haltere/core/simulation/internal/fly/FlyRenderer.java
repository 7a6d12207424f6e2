package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * Renders images of a fly in front of a light. The body transmits the share that the settings
 * state; the light behind a wing is multiplied by the transmission of membrane and veins. The share
 * of a pixel that a wing covers is exact. Lists the pixels whose light has changed.
 *
 * <p>Thread rule: one thread at a time.
 */
final class FlyRenderer {
  /** Motion of the ends of the body after which it is rendered again. */
  private static final double STALE_PX = 0.02;

  /** Width of a vein, pixels: a hundredth of a wing's length. */
  private static final double VEIN_PX = 0.5;

  private final RenderedFlySceneSettings settings;
  private final BodyShape shape;
  private final WingPlanform planform;
  private final int width;
  private final int height;
  private final double clearBody;

  /** The light without wings and without flicker. */
  private final double[] backdrop;

  private final double[] light;
  private final int[] changed;
  private int changes;
  private final CoverageRaster[] membrane = new CoverageRaster[2];
  private final CoverageRaster[] veins = new CoverageRaster[2];
  private final double[][] passed = new double[2][];
  private final double[] cornerX = new double[2 * WingPlanform.CORNERS + 2];
  private final double[] cornerY = new double[cornerX.length];

  /** Columns of each row that a wing covers or covered before, the last one exclusive. */
  private final int[] from;

  private final int[] to;
  private double bodyX = Double.NaN;
  private double bodyY;
  private double bodyHeading;
  private double flicker = 1;
  private boolean isStale;

  FlyRenderer(RenderedFlySceneSettings settings, WingPlanform planform) {
    this.settings = settings;
    this.planform = planform;
    SensorSettings sensor = settings.sensor();
    width = sensor.widthPx();
    height = sensor.heightPx();
    shape = new BodyShape(settings.fly().body().lengthPx());
    clearBody = StrictMath.exp(-settings.fly().body().contrast());
    backdrop = new double[width * height];
    light = new double[backdrop.length];
    changed = new int[backdrop.length];
    from = new int[height];
    to = new int[height];
    for (int side = 0; side < 2; side++) {
      membrane[side] = new CoverageRaster(width, height);
      veins[side] = new CoverageRaster(width, height);
      passed[side] = new double[backdrop.length];
      java.util.Arrays.fill(passed[side], 1);
    }
  }

  /** Renders the body and the flicker of the light. */
  void background(FlyPose pose, double seconds) {
    LightSettings source = settings.light();
    double now =
        1 + source.flickerShare() * StrictMath.sin(2 * Math.PI * source.flickerHz() * seconds);
    isStale = now != flicker;
    flicker = now;
    double turned = Math.abs(pose.heading - bodyHeading) * shape.reach();
    if (Math.abs(pose.centreX - bodyX) + Math.abs(pose.centreY - bodyY) + turned < STALE_PX) {
      return;
    }
    isStale = true;
    bodyX = pose.centreX;
    bodyY = pose.centreY;
    bodyHeading = pose.heading;
    double middleX = (width - 1) / 2.0;
    double middleY = (height - 1) / 2.0;
    double perSquarePx = source.vignetting() / (middleX * middleX + middleY * middleY);
    double reach = shape.reach() + BodyShape.band();
    for (int y = 0; y < height; y++) {
      double dy = y - middleY;
      for (int x = 0; x < width; x++) {
        double dx = x - middleX;
        double share = 1 - perSquarePx * (dx * dx + dy * dy);
        if (Math.abs(x - bodyX) < reach && Math.abs(y - bodyY) < reach) {
          share *= 1 - (1 - clearBody) * BodyShape.cover(shape.distance(pose, x, y));
        }
        backdrop[y * width + x] = share;
      }
    }
  }

  /**
   * Renders a wing.
   *
   * @param side left or right
   * @param hingeX of its hinge
   * @param hingeY of its hinge
   * @param direction of its axis on the sensor
   * @param projection visible share of its chord
   */
  void wing(int side, double hingeX, double hingeY, double direction, double projection) {
    double cos = StrictMath.cos(direction);
    double sin = StrictMath.sin(direction);
    double inFront = side == FlyKinematics.LEFT ? projection : -projection;
    forget(side, membrane[side]);
    forget(side, veins[side]);
    polygon(membrane[side], hingeX, hingeY, cos, sin, inFront, 0, 1, 0);
    int count = settings.fly().wing().veins();
    for (int i = 0; i < count; i++) {
      // Veins are in the front part of a wing.
      double share = 0.6 * i / count;
      polygon(veins[side], hingeX, hingeY, cos, sin, inFront, share, share, VEIN_PX / 2);
    }
    double membranePasses = 1 - settings.fly().wing().transmission();
    double veinPasses = 1 - settings.fly().wing().veinTransmission();
    show(side, membrane[side], membranePasses);
    show(side, veins[side], veinPasses);
  }

  private void forget(int side, CoverageRaster raster) {
    for (int y = raster.fromRow(); y < raster.toRow(); y++) {
      for (int x = raster.from(y); x < raster.to(y); x++) {
        passed[side][y * width + x] = 1;
      }
      look(raster, y);
    }
    raster.clear();
  }

  private void show(int side, CoverageRaster raster, double dark) {
    raster.finish();
    for (int y = raster.fromRow(); y < raster.toRow(); y++) {
      for (int x = raster.from(y); x < raster.to(y); x++) {
        passed[side][y * width + x] *= 1 - dark * raster.at(x, y);
      }
      look(raster, y);
    }
  }

  private void look(CoverageRaster raster, int y) {
    from[y] = Math.min(from[y], raster.from(y));
    to[y] = Math.max(to[y], raster.to(y));
  }

  /** Adds the area between two lines along the wing, each extended by a width. */
  private void polygon(
      CoverageRaster raster,
      double hingeX,
      double hingeY,
      double cos,
      double sin,
      double inFront,
      double first,
      double second,
      double widerPx) {
    int corners = 0;
    for (int i = 0; i <= WingPlanform.CORNERS; i++) {
      double across = inFront * planform.acrossPx(i, first) + widerPx;
      cornerX[corners] = hingeX + planform.spanPx(i) * cos - across * sin;
      cornerY[corners++] = hingeY + planform.spanPx(i) * sin + across * cos;
    }
    for (int i = WingPlanform.CORNERS; i >= 0; i--) {
      double across = inFront * planform.acrossPx(i, second) - widerPx;
      cornerX[corners] = hingeX + planform.spanPx(i) * cos - across * sin;
      cornerY[corners++] = hingeY + planform.spanPx(i) * sin + across * cos;
    }
    raster.add(cornerX, cornerY, corners);
  }

  /**
   * Finds the pixels whose light differs from that at the last call.
   *
   * @return their number
   */
  int findChanges() {
    changes = 0;
    for (int y = 0; y < height; y++) {
      int end = isStale ? width : to[y];
      for (int x = isStale ? 0 : from[y]; x < end; x++) {
        int pixel = y * width + x;
        double now = flicker * backdrop[pixel] * passed[0][pixel] * passed[1][pixel];
        if (now != light[pixel]) {
          light[pixel] = now;
          changed[changes++] = pixel;
        }
      }
      from[y] = width;
      to[y] = 0;
    }
    isStale = false;
    return changes;
  }

  /** One of the pixels that {@link #findChanges} has found. */
  int changed(int i) {
    return changed[i];
  }

  /** The light on a pixel at the last {@link #findChanges}. */
  double light(int pixel) {
    return light[pixel];
  }
}
