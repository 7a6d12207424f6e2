package haltere.ui.rendering;

/** Draws text as dots, each of which covers a share of its pixel. */
public interface Letters {
  interface Dots {
    /**
     * Takes a dot: column from the left, row from the top, and the share of the pixel that it
     * covers, 0 to 1.
     */
    void dot(int column, int row, double share);
  }

  /** Width of a line, pixels. */
  double width(String line);

  /** Room above the base line, pixels. */
  double ascent();

  /** Room below the base line, pixels. */
  double descent();

  /** Draws a line from its left end and its base line, pixels from the left and from the top. */
  void draw(String line, int left, int base, Dots dots);
}
