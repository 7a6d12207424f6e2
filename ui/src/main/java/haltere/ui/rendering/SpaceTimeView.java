package haltere.ui.rendering;

/**
 * The viewpoint on a cloud of events, and its highlighted slice.
 *
 * @param turnRad turn around the sensor's vertical; 0 looks along time
 * @param tiltRad tilt towards the looker
 * @param zoom 1 fits the box into the picture
 * @param spanUs time from the front to the back of the box
 * @param sliceFrom start of the highlighted slice, 0 (now) to 1 (the oldest)
 * @param sliceTo where it ends
 */
public record SpaceTimeView(
    double turnRad, double tiltRad, double zoom, long spanUs, double sliceFrom, double sliceTo) {
  /** From the side and somewhat from above, all of the last tenth of a second. */
  public static final SpaceTimeView DEFAULT =
      new SpaceTimeView(Math.toRadians(55), Math.toRadians(20), 1, 100_000, 0, 1);

  /** Checks the span. */
  public SpaceTimeView {
    if (spanUs < 1 || spanUs > Integer.MAX_VALUE) {
      throw new IllegalArgumentException("the span is 1 us to 35 min, not " + spanUs + " us");
    }
  }
}
