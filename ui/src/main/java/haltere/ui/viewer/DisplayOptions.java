package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;

/**
 * How events are shown.
 *
 * @param colours the map
 * @param decayUs time constant of the fading, or 0 to follow the length of the slices, so that slow
 *     motion shows short moments
 */
record DisplayOptions(ColourMap colours, long decayUs) {
  static final long FOLLOW_SLICES = 0;

  static final DisplayOptions DEFAULT = new DisplayOptions(ColourMap.DARK, FOLLOW_SLICES);
}
