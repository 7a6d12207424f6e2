package haltere.core.simulation.internal.road;

/** The kinds of vehicles of {@link RoadScene}, with their usual sizes. */
public enum VehicleKind {
  /** A car with a cabin. */
  CAR(1.8, 4.4, 1.45),
  /** A lorry: a cab before a tall load. */
  LORRY(2.5, 9, 3.5),
  /** A motorcycle with its rider. */
  MOTORCYCLE(0.8, 2.1, 1.6);

  private final double widthM;
  private final double lengthM;
  private final double heightM;

  VehicleKind(double widthM, double lengthM, double heightM) {
    this.widthM = widthM;
    this.lengthM = lengthM;
    this.heightM = heightM;
  }

  /**
   * Usual width.
   *
   * @return metres
   */
  public double widthM() {
    return widthM;
  }

  /**
   * Usual length.
   *
   * @return metres
   */
  public double lengthM() {
    return lengthM;
  }

  /**
   * Usual height.
   *
   * @return metres
   */
  public double heightM() {
    return heightM;
  }
}
