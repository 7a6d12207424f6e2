package haltere.filters.wing.tracker;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingPositionSettings;
import haltere.filters.wing.internal.search.FoundFly;
import haltere.filters.wing.internal.stroke.StrokeFrame;

/**
 * Position of the tracked fly: a frame for each wing, and the body line between left and right,
 * through the middle of the hinges along the heading.
 */
final class FlyPosition {
  private static final double MIN_REGION_PX = 3;

  final StrokeFrame[] frames = {new StrokeFrame(WingPart.LEFT), new StrokeFrame(WingPart.RIGHT)};
  private double axisCos = 1;
  private double axisSin;
  double axisX;
  double axisY;
  private double confidence;
  private long initialisedAtUs;
  double sizePx;
  double regionPx;

  /** Sets a found fly with the manual offsets. */
  void begin(FoundFly fly, WingPositionSettings offsets, long timeUs) {
    FlyGeometry found = fly.geometry();
    boolean flip = offsets.flipHeading();
    double heading = found.headingRad() + (flip ? Math.PI : 0) + offsets.headingOffsetRad();
    sizePx = found.sizePx();
    confidence = found.headTailConfidence();
    initialisedAtUs = timeUs;
    regionPx = Math.max(MIN_REGION_PX, fly.regionPx() + offsets.regionOffsetPx());
    for (int side = 0; side < 2; side++) {
      boolean left = side == 0 != flip;
      frames[side].place(
          (left ? found.leftHingeX() : found.rightHingeX()) + offsets.bodyOffsetXPx(),
          (left ? found.leftHingeY() : found.rightHingeY()) + offsets.bodyOffsetYPx(),
          heading,
          offsets.innerRadiusPx(),
          regionPx);
      frames[side].setManual(isManual(offsets));
    }
    settle();
  }

  private static boolean isManual(WingPositionSettings offsets) {
    return offsets.bodyOffsetXPx() != 0 || offsets.bodyOffsetYPx() != 0;
  }

  /** Exchanges head and tail, and with them left and right. */
  void exchange(double innerPx) {
    FlyGeometry now = geometry();
    double heading = frames[0].headingRad() + Math.PI;
    frames[0].place(now.rightHingeX(), now.rightHingeY(), heading, innerPx, regionPx);
    frames[1].place(now.leftHingeX(), now.leftHingeY(), heading, innerPx, regionPx);
  }

  /** Applies changed manual offsets; returns the rotation of the heading, radians. */
  double move(WingPositionSettings before, WingPositionSettings after) {
    double turn = Angles.wrapPi(after.headingOffsetRad() - before.headingOffsetRad());
    regionPx = Math.max(MIN_REGION_PX, regionPx + after.regionOffsetPx() - before.regionOffsetPx());
    for (StrokeFrame frame : frames) {
      frame.place(
          frame.hingeX() + after.bodyOffsetXPx() - before.bodyOffsetXPx(),
          frame.hingeY() + after.bodyOffsetYPx() - before.bodyOffsetYPx(),
          frame.headingRad() + turn,
          after.innerRadiusPx(),
          regionPx);
      frame.setManual(isManual(after));
    }
    settle();
    return turn;
  }

  /** Shifts both frames. */
  void shift(double byX, double byY) {
    frames[0].shift(byX, byY);
    frames[1].shift(byX, byY);
  }

  /** Turns both frames. */
  void turn(double by) {
    frames[0].setHeading(frames[0].headingRad() + by);
    frames[1].setHeading(frames[1].headingRad() + by);
  }

  /** Sets the region of interest by a size of the fly. */
  void resize(double size, WingPositionSettings offsets) {
    sizePx = size;
    regionPx = Math.max(MIN_REGION_PX, size + offsets.regionOffsetPx());
    for (StrokeFrame frame : frames) {
      frame.place(
          frame.hingeX(), frame.hingeY(), frame.headingRad(), offsets.innerRadiusPx(), regionPx);
    }
  }

  /** Computes the body line from the present frames. */
  void settle() {
    double heading = frames[0].headingRad();
    axisCos = Math.cos(heading);
    axisSin = Math.sin(heading);
    axisX = (frames[0].hingeX() + frames[1].hingeX()) / 2;
    axisY = (frames[0].hingeY() + frames[1].hingeY()) / 2;
  }

  /** Side of a pixel, 0 left, 1 right. */
  int side(int x, int y) {
    return (y - axisY) * axisCos - (x - axisX) * axisSin > 0 ? 0 : 1;
  }

  FlyGeometry geometry() {
    return new FlyGeometry(
        (frames[0].hingeX() + frames[1].hingeX()) / 2,
        (frames[0].hingeY() + frames[1].hingeY()) / 2,
        Angles.wrapTwoPi(frames[0].headingRad()),
        sizePx,
        frames[0].hingeX(),
        frames[0].hingeY(),
        frames[1].hingeX(),
        frames[1].hingeY(),
        confidence,
        initialisedAtUs);
  }
}
