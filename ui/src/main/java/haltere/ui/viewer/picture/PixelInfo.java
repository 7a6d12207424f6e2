package haltere.ui.viewer.picture;

import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.controls.Texts;

/**
 * Information on the pixel under the mouse.
 *
 * @param x column
 * @param y row, upwards
 * @param lastUs time of its last event, or {@link StreamNotification#NO_TIME_US}
 * @param on polarity of that event
 * @param ageUs how old it is
 * @param rateEps events per second of recording time in the {@link ViewProbes#NEAR} neighbours at
 *     each side; NaN if not known yet
 * @param frequencyHz at which the pixel flickers, NaN where that is not shown or not known
 */
record PixelInfo(
    int x, int y, long lastUs, boolean on, long ageUs, double rateEps, double frequencyHz) {
  /** The information as one line. */
  String label() {
    StringBuilder text = new StringBuilder("x " + x + "   y " + y);
    if (lastUs != StreamNotification.NO_TIME_US) {
      text.append("   ")
          .append(on ? "ON " : "OFF ")
          .append(Texts.duration(ageUs))
          .append(" ago   t ")
          .append(lastUs)
          .append(" \u00b5s");
    }
    if (!Double.isNaN(rateEps)) {
      text.append("   ").append(Texts.rate(rateEps)).append(" near");
    }
    if (!Double.isNaN(frequencyHz)) {
      text.append("   ").append(Texts.quantity(frequencyHz)).append(" Hz");
    }
    return text.toString();
  }
}
