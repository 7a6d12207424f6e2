package haltere.testing.objects;

import java.util.SplittableRandom;

/**
 * An element of a simulated picture that changes its logarithmic brightness: an object, a shadow or
 * a leaf. Thread rule: one thread at a time.
 */
final class Sprite {
  private static final int TEXTURE = 16;

  private final Motion motion;
  private final Shape shape;
  private final boolean followsHeading;
  private final double angleRad;
  private final double level;
  private boolean isShadow;
  private double offsetX;
  private double offsetY;
  private double[] texture = {};
  private double texturePx = 1;

  // The state at the time that is drawn.
  private double x;
  private double y;
  private double cos;
  private double sin;
  private double gaitRad;

  /**
   * A form of one brightness.
   *
   * @param motion where it is
   * @param shape its form
   * @param followsHeading whether it turns with its direction
   * @param angleRad how it is turned if it does not, radians
   * @param level logarithmic brightness over the background's
   */
  Sprite(Motion motion, Shape shape, boolean followsHeading, double angleRad, double level) {
    this.motion = motion;
    this.shape = shape;
    this.followsHeading = followsHeading;
    this.angleRad = angleRad;
    this.level = level;
  }

  /** Gives this a random texture. */
  void addTexture(SplittableRandom random, double contrast, double cellPx) {
    texture = random.doubles(TEXTURE * TEXTURE, -contrast, contrast).toArray();
    texturePx = cellPx;
  }

  /** The same with another motion. */
  Sprite on(Motion other) {
    Sprite sprite = new Sprite(other, shape, followsHeading, angleRad, level);
    sprite.texture = texture;
    sprite.texturePx = texturePx;
    return sprite;
  }

  /** The shadow of this, which darkens the layers below. */
  Sprite shadow(double darkening, double dx, double dy) {
    Sprite shadow = new Sprite(motion, shape, followsHeading, angleRad, -darkening);
    shadow.isShadow = true;
    shadow.offsetX = dx;
    shadow.offsetY = dy;
    return shadow;
  }

  Motion motion() {
    return motion;
  }

  Shape shape() {
    return shape;
  }

  private double angle(double s) {
    return followsHeading ? motion.headingRad(s) : angleRad;
  }

  /** Full extent at a time, of an object without its shadow. */
  Box box(double s) {
    return shape.extent(angle(s)).mapped(1, 1, motion.x(s) + offsetX, motion.y(s) + offsetY);
  }

  /** Goes to a time. */
  void moveTo(double s) {
    x = motion.x(s) + offsetX;
    y = motion.y(s) + offsetY;
    cos = Math.cos(angle(s));
    sin = Math.sin(angle(s));
    if (shape.kind() == Shape.ShapeKind.WALKER) {
      double speed = Math.hypot(motion.ax(), motion.ay());
      gaitRad = shape.gaitRad(speed * motion.progressS(s));
    }
  }

  /** Covered share of a pixel at its time, 0 to 1. */
  double coverage(double px, double py) {
    double dx = px - x;
    double dy = py - y;
    return shape.coverage(dx * cos + dy * sin, dy * cos - dx * sin, gaitRad);
  }

  /** Logarithmic brightness of a pixel with this over the layers below. */
  double over(double under, double px, double py) {
    double cover = coverage(px, py);
    if (cover == 0) {
      return under;
    }
    if (isShadow) {
      return under + cover * level;
    }
    double own = level;
    if (texture.length > 0) {
      double dx = px - x;
      double dy = py - y;
      own += textureAt((dx * cos + dy * sin) / texturePx, (dy * cos - dx * sin) / texturePx);
    }
    return under + cover * (own - under);
  }

  /** Bilinear between the cells. */
  private double textureAt(double u, double v) {
    int i = (int) Math.floor(u);
    int j = (int) Math.floor(v);
    double fu = u - i;
    double fv = v - j;
    return (1 - fv) * ((1 - fu) * cell(i, j) + fu * cell(i + 1, j))
        + fv * ((1 - fu) * cell(i, j + 1) + fu * cell(i + 1, j + 1));
  }

  private double cell(int i, int j) {
    return texture[Math.floorMod(i, TEXTURE) * TEXTURE + Math.floorMod(j, TEXTURE)];
  }
}
