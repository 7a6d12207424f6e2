package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamNotification;
import haltere.filters.frequency.RegionMeasurement;
import haltere.ui.rendering.OverlaySnapshots;
import java.util.List;
import java.util.Optional;

/**
 * A finished picture: pixels and marks of the same moment. Filled by the painting thread, shown by
 * the JavaFX thread, passed by a {@link haltere.ui.rendering.FrameExchange}.
 */
public final class DisplayFrame {
  final SensorGeometry geometry;

  /** One for each of the sensor's, row by row from the top, with its rank for the scaler. */
  final int[] pixels;

  /** The pixels in screen resolution, with the marks; valid with a mapping. */
  int[] screen = {};

  /** The mapping of the screen's pixels to the sensor. */
  Optional<ScreenMapping> screenMapping = Optional.empty();

  List<OverlaySnapshots.Marks<?>> marks = List.of();

  /** Information on the pixel under the mouse. */
  Optional<PixelInfo> pixel = Optional.empty();

  Optional<RegionMeasurement> region = Optional.empty();

  /** Meaning of the ends of the colours, empty for polarities. */
  String scale = "";

  /** The same moment of the second chain in a comparison. */
  Optional<DisplayFrame> beside = Optional.empty();

  long timeUs = StreamNotification.NO_TIME_US;
  boolean dark = true;

  DisplayFrame(SensorGeometry geometry) {
    this.geometry = geometry;
    this.pixels = new int[geometry.pixels()];
  }

  /** Measurement of the region of interest; empty without one. */
  public Optional<RegionMeasurement> region() {
    return region;
  }

  /** The same moment of the second chain; empty without a comparison. */
  public Optional<DisplayFrame> beside() {
    return beside;
  }

  /**
   * End of the shown slice, microseconds of the stream; {@link StreamNotification#NO_TIME_US}
   * before the first events.
   */
  public long timeUs() {
    return timeUs;
  }
}
