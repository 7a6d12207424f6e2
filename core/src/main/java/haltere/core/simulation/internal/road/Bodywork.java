package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.ArrayList;
import java.util.List;

/**
 * Size, shape and paint of one vehicle, drawn at random from the settings.
 *
 * <p>Thread rule: immutable.
 *
 * @param kind of the vehicle
 * @param widthM metres
 * @param lengthM metres
 * @param parts its visible parts
 */
record Bodywork(VehicleKind kind, double widthM, double lengthM, List<PaintedBox> parts) {
  private static final double GLASS = -1.0;
  private static final double TYRES = -1.2;
  private static final double LAMPS = 0.6;
  private static final double HELMET = 0.5;
  private static final double CLOTHES = -0.9;
  private static final double DARKER_SHARE = 2.0 / 3;

  static Bodywork draw(
      VehicleKind kind, boolean away, VehicleSettings settings, SeededRandom random) {
    double spread = settings.sizeSpread();
    double width = kind.widthM() * (1 + random.between(-spread, spread));
    double length = kind.lengthM() * (1 + random.between(-spread, spread));
    double height = kind.heightM() * (1 + random.between(-spread, spread)) * settings.heightShare();
    double contrast = settings.contrast() * (1 + settings.contrastSpread() * random.gaussian());
    double body = random.nextDouble() < DARKER_SHARE ? -contrast : contrast;
    Painter painter = new Painter(width, length, height, away, body, settings.texture(), random);
    switch (kind) {
      case CAR -> painter.car();
      case LORRY -> painter.lorry();
      default -> painter.motorcycle();
    }
    return new Bodywork(kind, width, length, List.copyOf(painter.parts));
  }

  private static final class Painter {
    final List<PaintedBox> parts = new ArrayList<>();
    private final double width;
    private final double length;
    private final double height;
    private final boolean away;
    private final double body;
    private final double texture;
    private final SeededRandom random;

    Painter(
        double width,
        double length,
        double height,
        boolean away,
        double body,
        double texture,
        SeededRandom random) {
      this.width = width;
      this.length = length;
      this.height = height;
      this.away = away;
      this.body = body;
      this.texture = texture;
      this.random = random;
    }

    /** Light of a detail of the body, scaled by the texture setting. */
    private double detail(double light) {
      return body + texture * (light - body);
    }

    private double shade(double change) {
      return body + texture * change;
    }

    /** A part whose position is given as shares of the vehicle, along it from the rear. */
    private PaintedBox part(
        double widthShare, double fromRear, double toRear, double bottom, double top) {
      double half = width * widthShare / 2;
      double near = away ? fromRear : 1 - toRear;
      double far = away ? toRear : 1 - fromRear;
      PaintedBox box =
          new PaintedBox(-half, half, near * length, far * length, bottom * height, top * height);
      box.paintAll(PaintedBox.NEAR, shade(-0.15));
      box.paintAll(PaintedBox.SIDE, shade(-0.25));
      for (int row = 0; row < PaintedBox.ROWS; row++) {
        for (int column = 0; column < PaintedBox.COLUMNS; column++) {
          double light = shade(0.1 + random.between(-0.08, 0.08));
          box.paint(PaintedBox.TOP, column, column, row, row, light);
        }
      }
      parts.add(box);
      return box;
    }

    void car() {
      double rear = random.between(0.08, 0.2);
      part(1, 0, 1, 0, 0.58)
          .paint(PaintedBox.NEAR, 0, 7, 0, 0, detail(TYRES))
          .paint(PaintedBox.NEAR, 0, 1, 2, 2, detail(LAMPS))
          .paint(PaintedBox.NEAR, 6, 7, 2, 2, detail(LAMPS))
          .paint(PaintedBox.NEAR, 3, 4, 1, 1, detail(0.3))
          .paint(PaintedBox.SIDE, 1, 1, 0, 1, detail(TYRES))
          .paint(PaintedBox.SIDE, 6, 6, 0, 1, detail(TYRES));
      part(0.86, rear, rear + 0.52, 0.58, 1)
          .paint(PaintedBox.NEAR, 1, 6, 0, 2, detail(GLASS))
          .paint(PaintedBox.SIDE, 1, 3, 0, 2, detail(GLASS))
          .paint(PaintedBox.SIDE, 5, 6, 0, 2, detail(GLASS));
    }

    void lorry() {
      double load = random.between(0.7, 0.78);
      PaintedBox box =
          part(1, 0, load, 0, 1)
              .paint(PaintedBox.NEAR, 0, 7, 0, 0, detail(TYRES))
              .paint(PaintedBox.SIDE, 1, 2, 0, 0, detail(TYRES))
              .paint(PaintedBox.SIDE, 6, 6, 0, 0, detail(TYRES));
      box.paint(PaintedBox.TOP, 0, 7, 1, 1, shade(-0.35));
      box.paint(PaintedBox.TOP, 0, 7, 3, 3, shade(-0.35));
      PaintedBox cab = part(0.96, load + 0.03, 1, 0, 0.82);
      if (away) {
        box.paint(PaintedBox.NEAR, 0, 0, 1, 1, detail(LAMPS))
            .paint(PaintedBox.NEAR, 7, 7, 1, 1, detail(LAMPS))
            .paint(PaintedBox.NEAR, 2, 5, 2, 3, shade(0.3));
      } else {
        cab.paint(PaintedBox.NEAR, 1, 6, 2, 2, detail(GLASS))
            .paint(PaintedBox.NEAR, 0, 7, 0, 0, detail(TYRES))
            .paint(PaintedBox.NEAR, 0, 1, 1, 1, detail(LAMPS))
            .paint(PaintedBox.NEAR, 6, 7, 1, 1, detail(LAMPS));
      }
    }

    void motorcycle() {
      part(0.5, 0, 1, 0, 0.5)
          .paint(PaintedBox.NEAR, 0, 7, 0, 1, detail(TYRES))
          .paint(PaintedBox.NEAR, 2, 5, 2, 2, detail(LAMPS));
      PaintedBox rider = part(1, 0.3, 0.62, 0.5, 0.85);
      rider.paintAll(PaintedBox.NEAR, detail(CLOTHES));
      rider.paintAll(PaintedBox.TOP, detail(CLOTHES));
      rider.paintAll(PaintedBox.SIDE, detail(CLOTHES));
      PaintedBox head = part(0.4, 0.4, 0.55, 0.85, 1);
      head.paintAll(PaintedBox.NEAR, detail(HELMET));
      head.paintAll(PaintedBox.TOP, detail(HELMET));
    }
  }
}
