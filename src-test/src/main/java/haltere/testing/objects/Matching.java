package haltere.testing.objects;

/** When a track is on an object. The distance is at most 1 where it is. */
public enum Matching {
  /** Inside the object's box and {@value #MARGIN_PX} pixels more on each side. */
  BOX {
    @Override
    public double distance(Box box, double x, double y) {
      double distance =
          Math.max(
              Math.abs(x - box.centreX()) / (box.width() / 2 + MARGIN_PX),
              Math.abs(y - box.centreY()) / (box.height() / 2 + MARGIN_PX));
      // Rounding does not decide whether a track on the very border is inside.
      return box.contains(x, y, MARGIN_PX)
          ? Math.min(1, distance)
          : Math.max(Math.nextUp(1.0), distance);
    }
  },
  /** Inside the ellipse of the box's half sides, each at least {@value #MARGIN_PX} pixels. */
  CENTRE {
    @Override
    public double distance(Box box, double x, double y) {
      return Math.hypot(
          (x - box.centreX()) / Math.max(MARGIN_PX, box.width() / 2),
          (y - box.centreY()) / Math.max(MARGIN_PX, box.height() / 2));
    }
  },
  /** At most {@value #GATE_PX} pixels from the centre. */
  GATE {
    @Override
    public double distance(Box box, double x, double y) {
      return Math.hypot(x - box.centreX(), y - box.centreY()) / GATE_PX;
    }
  };

  /** Tolerance of labelled boxes, and least half axis of a match by centre, pixels. */
  public static final double MARGIN_PX = 4;

  /** Distance up to which a track is on a vehicle or a disc, pixels. */
  public static final double GATE_PX = 10;

  /**
   * Distance of a track from an object in units of the tolerance.
   *
   * @param box the object's full extent
   * @param x column of the track, pixels
   * @param y row of the track, pixels
   * @return at least 0, at most 1 on the object
   */
  public abstract double distance(Box box, double x, double y);
}
