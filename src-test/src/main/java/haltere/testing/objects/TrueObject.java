package haltere.testing.objects;

/**
 * Where an object truly is at one time.
 *
 * @param id identity within its scene, at least 0
 * @param box full extent, hidden parts included
 * @param vxPxS velocity of the centre to the right, pixels a second; NaN if unknown
 * @param vyPxS velocity of the centre upwards, pixels a second; NaN if unknown
 */
public record TrueObject(int id, Box box, double vxPxS, double vyPxS) {
  /**
   * An object of unknown velocity.
   *
   * @param id identity within its scene
   * @param box full extent
   */
  public TrueObject(int id, Box box) {
    this(id, box, Double.NaN, Double.NaN);
  }
}
