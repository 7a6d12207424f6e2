package haltere.ui.rendering;

/** Draws words as dots, each of which covers a share of its pixel. */
public interface Letters {
  /** Takes a dot. */
  interface Dots {
    /**
     * A dot.
     *
     * @param column from the left
     * @param row from the top
     * @param share of the pixel that it covers, 0 to 1
     */
    void dot(int column, int row, double share);
  }

  /**
   * Width of a line.
   *
   * @param line words
   * @return pixels
   */
  double width(String line);

  /**
   * Room above the base line.
   *
   * @return pixels
   */
  double ascent();

  /**
   * Room below the base line.
   *
   * @return pixels
   */
  double descent();

  /**
   * Draws a line.
   *
   * @param line words
   * @param left where it begins, pixels
   * @param base its base line, pixels from the top
   * @param dots takes it
   */
  void draw(String line, int left, int base, Dots dots);
}
