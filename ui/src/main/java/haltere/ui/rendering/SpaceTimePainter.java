package haltere.ui.rendering;

import haltere.core.event.EventAddress;
import java.util.Arrays;

/** Paints events in space and time; the nearer of two events hides the other. */
public final class SpaceTimePainter {
  private static final int SHADES = 64;
  private static final double OLDEST_SHADE = 0.35;
  private static final double OUTSIDE_SHADE = 0.13;

  private final int[] shades = new int[4 * SHADES];
  private float[] depths = new float[0];
  private ColourMap colours;

  /**
   * Paints events by a projection, row by row from the top; the view defines the highlighted part.
   */
  public void paint(
      SpaceTimeCloud.Points points,
      SpaceTimeProjection projection,
      SpaceTimeView view,
      ColourMap newColours,
      int width,
      int height,
      int[] argb) {
    setColours(newColours);
    Arrays.fill(argb, 0, width * height, colours.background());
    if (depths.length < width * height) {
      depths = new float[width * height];
    }
    Arrays.fill(depths, 0, width * height, Float.NEGATIVE_INFINITY);
    double shadePerUs = (SHADES - 1.0) / view.spanUs();
    double fromUs = view.sliceFrom() * view.spanUs();
    double toUs = view.sliceTo() * view.spanUs();
    for (int i = 0; i < points.count; i++) {
      int ageUs = points.agesUs[i];
      int address = points.addresses[i];
      int x = EventAddress.x(address);
      int y = EventAddress.y(address);
      int column = (int) (width / 2.0 + projection.across(x, ageUs));
      int row = (int) (height / 2.0 - projection.up(x, y, ageUs));
      if (column < 0 || row < 0 || column >= width - 1 || row >= height - 1) {
        continue;
      }
      float near = (float) projection.near(x, y, ageUs);
      boolean inside = ageUs >= fromUs && ageUs <= toUs;
      int shade =
          (EventAddress.isOn(address) ? SHADES : 0)
              + (inside ? 0 : 2 * SHADES)
              + (int) Math.min(SHADES - 1, ageUs * shadePerUs);
      int position = row * width + column;
      int colour = shades[shade];
      dot(position, near, colour, argb);
      dot(position + 1, near, colour, argb);
      dot(position + width, near, colour, argb);
      dot(position + width + 1, near, colour, argb);
    }
  }

  private void dot(int position, float near, int colour, int[] argb) {
    if (near >= depths[position]) {
      depths[position] = near;
      argb[position] = colour;
    }
  }

  private void setColours(ColourMap newColours) {
    if (!newColours.equals(colours)) {
      colours = newColours;
      for (int i = 0; i < SHADES; i++) {
        double fresh = 1 - (1 - OLDEST_SHADE) * i / (SHADES - 1);
        shades[i] = colours.colour(false, fresh);
        shades[SHADES + i] = colours.colour(true, fresh);
        shades[2 * SHADES + i] = colours.colour(false, fresh * OUTSIDE_SHADE);
        shades[3 * SHADES + i] = colours.colour(true, fresh * OUTSIDE_SHADE);
      }
    }
  }
}
