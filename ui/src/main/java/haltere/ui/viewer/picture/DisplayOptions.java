package haltere.ui.viewer.picture;

import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;

/**
 * Options of the display of events.
 *
 * @param mode meaning of the colour of a pixel
 * @param colours for polarities
 * @param gradient for ages and counts
 * @param decayUs time constant of the fading; or {@link #FOLLOW_SLICES}, so that slow motion shows
 *     short moments; or {@link #SLICE_ONLY}; or {@link #ACCUMULATE}
 * @param frameOpacity how much of the camera's frames is seen below the events: 0 nothing, 1 all
 */
public record DisplayOptions(
    DisplayMode mode, ColourMap colours, Gradient gradient, long decayUs, double frameOpacity) {
  /** The fading follows the length of the slices. */
  public static final long FOLLOW_SLICES = 0;

  /** No fading: the events of the last slice and no others, as in a photograph of that exposure. */
  public static final long SLICE_ONLY = -1;

  /** No fading: all events of the last minutes, as far as a picture remembers them. */
  public static final long ACCUMULATE = -2;

  /**
   * Those of a new window: polarities in the dark over faint frames, fading as fast as slices go
   * by.
   */
  public static final DisplayOptions DEFAULT =
      new DisplayOptions(
          DisplayMode.POLARITY, ColourMap.DARK, Gradient.CIVIDIS, FOLLOW_SLICES, 0.6);

  /** A fading that follows the slices has this many times their length, within these limits. */
  private static final double DECAY_PER_SLICE = 2.5;

  private static final double MIN_DECAY_US = 20;
  private static final double MAX_DECAY_US = 1_000_000;

  /** These options for slices of one length, with the fading that follows it. */
  public DisplayOptions forSlices(double sliceUs) {
    if (decayUs != FOLLOW_SLICES) {
      return this;
    }
    double us = Math.max(MIN_DECAY_US, Math.min(MAX_DECAY_US, sliceUs * DECAY_PER_SLICE));
    return new DisplayOptions(mode, colours, gradient, Math.round(us), frameOpacity);
  }
}
