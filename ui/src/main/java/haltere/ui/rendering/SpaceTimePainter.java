package haltere.ui.rendering;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Paints events in space and time: the sensor's columns and rows, and time as the third axis, in
 * parallel projection. Of two events at one place the nearer one is seen.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class SpaceTimePainter {
  /** Length of the time axis as a share of the sensor's longer side. */
  private static final double DEPTH = 1.6;

  private static final double MARGIN = 0.88;
  private static final int SHADES = 64;
  private static final double OLDEST_SHADE = 0.35;
  private static final double OUTSIDE_SHADE = 0.13;

  private final int[] shades = new int[4 * SHADES];
  private float[] depths = new float[0];
  private ColourMap colours;

  // of the view: sensor and time to picture
  private double scale;
  private double cosTurn;
  private double sinTurn;
  private double cosTilt;
  private double sinTilt;
  private double middleX;
  private double middleY;

  /** Paints the events of a sensor, seen from a view, into a picture, row by row from the top. */
  public void paint(
      SpaceTimeCloud.Points points,
      SensorGeometry sensor,
      SpaceTimeView view,
      ColourMap newColours,
      int width,
      int height,
      int[] argb) {
    prepare(view, newColours, sensor, width, height);
    Arrays.fill(argb, 0, width * height, colours.background());
    if (depths.length < width * height) {
      depths = new float[width * height];
    }
    Arrays.fill(depths, 0, width * height, Float.NEGATIVE_INFINITY);
    double longer = sensor.longerSide();
    double halfWidth = (sensor.width() - 1) / 2.0;
    double halfHeight = (sensor.height() - 1) / 2.0;
    double perUs = DEPTH * longer / view.spanUs();
    double halfDepth = DEPTH * longer / 2;
    box(halfWidth, halfHeight, halfDepth, width, height, argb);
    double shadePerUs = (SHADES - 1.0) / view.spanUs();
    double fromUs = view.sliceFrom() * view.spanUs();
    double toUs = view.sliceTo() * view.spanUs();
    for (int i = 0; i < points.count; i++) {
      int ageUs = points.agesUs[i];
      int address = points.addresses[i];
      double x = EventAddress.x(address) - halfWidth;
      double y = EventAddress.y(address) - halfHeight;
      double z = halfDepth - ageUs * perUs;
      double across = x * cosTurn + z * sinTurn;
      double away = z * cosTurn - x * sinTurn;
      double up = y * cosTilt - away * sinTilt;
      float near = (float) (away * cosTilt + y * sinTilt);
      int column = (int) (middleX + across * scale);
      int row = (int) (middleY - up * scale);
      if (column < 0 || row < 0 || column >= width - 1 || row >= height - 1) {
        continue;
      }
      boolean inside = ageUs >= fromUs && ageUs <= toUs;
      int shade =
          (EventAddress.isOn(address) ? SHADES : 0)
              + (inside ? 0 : 2 * SHADES)
              + (int) Math.min(SHADES - 1, ageUs * shadePerUs);
      int place = row * width + column;
      int colour = shades[shade];
      dot(place, near, colour, argb);
      dot(place + 1, near, colour, argb);
      dot(place + width, near, colour, argb);
      dot(place + width + 1, near, colour, argb);
    }
  }

  private void dot(int place, float near, int colour, int[] argb) {
    if (near >= depths[place]) {
      depths[place] = near;
      argb[place] = colour;
    }
  }

  private void prepare(
      SpaceTimeView view, ColourMap newColours, SensorGeometry sensor, int width, int height) {
    cosTurn = Math.cos(view.turnRad());
    sinTurn = Math.sin(view.turnRad());
    cosTilt = Math.cos(view.tiltRad());
    sinTilt = Math.sin(view.tiltRad());
    double longer = sensor.longerSide();
    double boxWidth = sensor.width() * Math.abs(cosTurn) + DEPTH * longer * Math.abs(sinTurn);
    double boxDepth = sensor.width() * Math.abs(sinTurn) + DEPTH * longer * Math.abs(cosTurn);
    double boxHeight = sensor.height() * Math.abs(cosTilt) + boxDepth * Math.abs(sinTilt);
    scale = view.zoom() * MARGIN * Math.min(width / boxWidth, height / boxHeight);
    middleX = width / 2.0;
    middleY = height / 2.0;
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

  /** The twelve edges of the box. */
  private void box(
      double halfWidth, double halfHeight, double halfDepth, int width, int height, int[] argb) {
    int colour = ColourMap.mix(colours.background(), colours.dark() ? 0xFFFFFFFF : 0xFF000000, 0.3);
    for (int a = 0; a < 8; a++) {
      for (int axis = 1; axis < 8; axis <<= 1) {
        if ((a & axis) == 0) {
          int b = a | axis;
          edge(
              corner(a, 1, halfWidth),
              corner(a, 2, halfHeight),
              corner(a, 4, halfDepth),
              corner(b, 1, halfWidth),
              corner(b, 2, halfHeight),
              corner(b, 4, halfDepth),
              colour,
              width,
              height,
              argb);
        }
      }
    }
  }

  private static double corner(int which, int axis, double half) {
    return (which & axis) == 0 ? -half : half;
  }

  private void edge(
      double x1,
      double y1,
      double z1,
      double x2,
      double y2,
      double z2,
      int colour,
      int width,
      int height,
      int[] argb) {
    double fromX = screenX(x1, z1);
    double fromY = screenY(x1, y1, z1);
    double toX = screenX(x2, z2);
    double toY = screenY(x2, y2, z2);
    int steps = (int) Math.min(8192, Math.max(Math.abs(toX - fromX), Math.abs(toY - fromY)) + 1);
    for (int i = 0; i <= steps; i++) {
      int column = (int) (fromX + (toX - fromX) * i / steps);
      int row = (int) (fromY + (toY - fromY) * i / steps);
      if (column >= 0 && row >= 0 && column < width && row < height) {
        argb[row * width + column] = colour;
      }
    }
  }

  private double screenX(double x, double z) {
    return middleX + (x * cosTurn + z * sinTurn) * scale;
  }

  private double screenY(double x, double y, double z) {
    return middleY - (y * cosTilt - (z * cosTurn - x * sinTurn) * sinTilt) * scale;
  }
}
