package haltere.filters.track.kalman;

/**
 * How far the parts of a thing reach: a circle about a middle that keeps its distance to the track
 * that has the thing's identity. It grows at once and shrinks slowly, for parts come and go. Thread
 * rule: that of its owner.
 */
final class ThingExtent {
  /** Share by which it shrinks, and by which its middle moves, with each step. */
  private static final double SHRINKING = 0.01;

  /** Middle, relative to the track, pixels. */
  private double offsetX;

  private double offsetY;

  /** Pixels; 0 as long as the thing has no parts. */
  private double radius;

  // What the parts of one step reach.
  private double sum;
  private double sumX;
  private double sumY;

  void clear() {
    offsetX = 0;
    offsetY = 0;
    radius = 0;
  }

  double radiusPx() {
    return radius;
  }

  /** Begins to look at the parts of a step. */
  void start() {
    sum = 0;
    sumX = 0;
    sumY = 0;
  }

  /** Takes a part, or the track itself, for the middle. */
  void add(Track whole, Track part) {
    double weight = part.radiusPx * part.radiusPx;
    sum += weight;
    sumX += weight * (part.nowXPx - whole.nowXPx);
    sumY += weight * (part.nowYPx - whole.nowYPx);
  }

  /** All of a step were added: moves the middle. */
  void settle() {
    double share = radius == 0 ? 1 : 10 * SHRINKING;
    offsetX += share * (sumX / sum - offsetX);
    offsetY += share * (sumY / sum - offsetY);
    radius -= SHRINKING * radius;
  }

  /** Lets it reach over a part. */
  void cover(Track whole, Track part) {
    radius = Math.max(radius, distance(whole, part.nowXPx, part.nowYPx) + part.radiusPx);
  }

  /** Takes over that of the track that had the identity before. */
  void take(ThingExtent other, Track from, Track to) {
    offsetX = other.offsetX + from.nowXPx - to.nowXPx;
    offsetY = other.offsetY + from.nowYPx - to.nowYPx;
    radius = other.radius;
  }

  /** How far a place is from the middle. */
  double distance(Track whole, double xPx, double yPx) {
    double dx = xPx - whole.nowXPx - offsetX;
    double dy = yPx - whole.nowYPx - offsetY;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** The same when the track lost its cluster. */
  double distanceWhenLost(Track whole, double xPx, double yPx) {
    return Math.hypot(xPx - whole.lostXPx - offsetX, yPx - whole.lostYPx - offsetY);
  }
}
