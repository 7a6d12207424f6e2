package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.PixelArray;
import java.util.Arrays;

/**
 * The flicker of the body's outline: as the body sways, the light on the pixels around its outline
 * changes a little. Each of them is evaluated once in two milliseconds, at its own time.
 *
 * <p>Thread rule: one thread at a time.
 */
final class BodyOutline {
  private final BodyShape shape;
  private final PixelArray pixels;
  private final WireMask wire;
  private final double contrast;
  private final int width;
  private final int height;
  private final int groups;
  private final double[] light;
  private final int[] found;
  private final int[] band;
  private final int[] groupEnd;
  private int bandSize;
  private final FlyPose bandPose = new FlyPose();
  private final FlyKinematics kinematics;

  BodyOutline(
      FlySceneSettings settings,
      BodyShape shape,
      PixelArray pixels,
      WireMask wire,
      FlyKinematics kinematics,
      int groups) {
    this.shape = shape;
    this.pixels = pixels;
    this.wire = wire;
    this.kinematics = kinematics;
    this.groups = groups;
    contrast = settings.fly().body().contrast();
    width = settings.sensor().widthPx();
    height = settings.sensor().heightPx();
    light = new double[width * height];
    found = new int[width * height];
    band = new int[width * height];
    groupEnd = new int[groups + 1];
    kinematics.sample(0, bandPose);
    for (int pixel = 0; pixel < light.length; pixel++) {
      light[pixel] = lightOn(pixel, bandPose);
      pixels.settle(pixel, light[pixel]);
    }
    findBand();
  }

  private double lightOn(int pixel, FlyPose pose) {
    int y = pixel / width;
    int x = pixel - y * width;
    return wire.hides(pixel) ? 0 : -contrast * BodyShape.cover(shape.distance(pose, x, y));
  }

  private void findBand() {
    bandSize = 0;
    double reach = shape.reach() + BodyShape.band();
    int fromX = (int) Math.max(0, Math.floor(bandPose.centreX - reach));
    int toX = (int) Math.min(width - 1, Math.ceil(bandPose.centreX + reach));
    int fromY = (int) Math.max(0, Math.floor(bandPose.centreY - reach));
    int toY = (int) Math.min(height - 1, Math.ceil(bandPose.centreY + reach));
    for (int y = fromY; y <= toY; y++) {
      for (int x = fromX; x <= toX; x++) {
        int pixel = y * width + x;
        if (!wire.hides(pixel) && Math.abs(shape.distance(bandPose, x, y)) < BodyShape.band()) {
          found[bandSize++] = pixel;
        }
      }
    }
    // Pixels of a group are adjacent.
    Arrays.fill(groupEnd, 0);
    for (int i = 0; i < bandSize; i++) {
      groupEnd[hash(found[i]) % groups + 1]++;
    }
    for (int group = 0; group < groups; group++) {
      groupEnd[group + 1] += groupEnd[group];
    }
    for (int i = 0; i < bandSize; i++) {
      band[groupEnd[hash(found[i]) % groups]++] = found[i];
    }
  }

  /** A hash of a pixel, independent of its position, 0 to 65535. */
  private static int hash(int pixel) {
    return (pixel * 0x9e3779b1) >>> 16;
  }

  /**
   * Evaluates the pixels of a group.
   *
   * @param group 0 to groups - 1
   * @param fromUs start of the time range
   * @param lengthUs length of the time range
   * @param pose of the body in it
   */
  void look(int group, double fromUs, double lengthUs, FlyPose pose) {
    if (contrast == 0) {
      return;
    }
    if (hasMoved(pose)) {
      // The old band is evaluated once more, so that its pixels return to the background.
      for (int i = 0; i < bandSize; i++) {
        see(band[i], fromUs, pose);
      }
      kinematics.sample((fromUs + lengthUs / 2) * 1e-6, bandPose);
      findBand();
      for (int i = 0; i < bandSize; i++) {
        see(band[i], fromUs, pose);
      }
    }
    for (int i = group == 0 ? 0 : groupEnd[group - 1]; i < groupEnd[group]; i++) {
      double share = (hash(band[i]) / groups & 0xff) / 256.0;
      see(band[i], fromUs + lengthUs * share, pose);
    }
  }

  private void see(int pixel, double timeUs, FlyPose pose) {
    double now = lightOn(pixel, pose);
    if (now != light[pixel]) {
      pixels.change(pixel, Math.max(timeUs, pixels.computedUntilUs(pixel)), now - light[pixel]);
      light[pixel] = now;
    }
  }

  private boolean hasMoved(FlyPose pose) {
    double turned = Math.abs(pose.heading - bandPose.heading) * shape.reach();
    return Math.abs(pose.centreX - bandPose.centreX)
            + Math.abs(pose.centreY - bandPose.centreY)
            + turned
        > 1;
  }
}
