package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamNotification;
import haltere.filters.frequency.RegionReading;
import haltere.ui.rendering.LayerTaps;
import java.util.List;
import java.util.Optional;

/**
 * A finished picture: the pixels and the marks of the same moment. Filled by the thread that
 * paints, shown by the JavaFX thread, handed over by a {@link haltere.ui.rendering.FrameExchange}.
 */
public final class DisplayFrame {
  final SensorGeometry geometry;

  /** One for each of the sensor's, row by row from the top, with its rank for the scaler. */
  final int[] pixels;

  /** The same as it is on the screen, with the marks; of use if there is a place. */
  int[] screen = {};

  /** What part of the sensor the screen's pixels show. */
  Optional<ScreenPlace> screenPlace = Optional.empty();

  List<LayerTaps.Marks<?>> marks = List.of();

  /** What there is to say of the pixel under the mouse. */
  Optional<PixelReading> pixel = Optional.empty();

  /** What the region of interest is doing. */
  Optional<RegionReading> region = Optional.empty();

  /** What the ends of the colours mean, empty where colours stand for polarities. */
  String scale = "";

  /** The same moment behind the second chain, where two are compared. */
  Optional<DisplayFrame> beside = Optional.empty();

  long timeUs = StreamNotification.NO_TIME_US;
  boolean dark = true;

  DisplayFrame(SensorGeometry geometry) {
    this.geometry = geometry;
    this.pixels = new int[geometry.pixels()];
  }

  /** What the region of interest is doing; empty where there is none. */
  public Optional<RegionReading> region() {
    return region;
  }

  /** The same moment behind the second chain; empty where no two are compared. */
  public Optional<DisplayFrame> beside() {
    return beside;
  }

  /**
   * End of what is shown, microseconds of the stream; {@link StreamNotification#NO_TIME_US} before
   * the first events.
   */
  public long timeUs() {
    return timeUs;
  }
}
