package haltere.ui.rendering;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.Optional;

/**
 * Accumulates events and paints them in any style. State beyond the last event of each pixel is
 * accumulated only while a style needs it.
 *
 * <p>Thread rule: one thread at a time, in the viewer the processing thread.
 */
public final class EventPicture implements StreamHandler {
  private final EventFrame frame;
  private final FramePainter painter;
  private PictureStyle style;

  /** What a style needs beyond the last event of each pixel; empty for others. */
  private Optional<StyleState> gathered = Optional.empty();

  /** A picture without events; events outside the sensor are ignored. */
  public EventPicture(SensorGeometry geometry, PictureStyle style) {
    frame = new EventFrame(geometry);
    painter = new FramePainter(style.colours(), style.timeConstantUs());
    configure(style);
  }

  /** The last event of each pixel; this picture's own, not to be changed. */
  public EventFrame frame() {
    return frame;
  }

  /** The style in use. */
  public PictureStyle style() {
    return style;
  }

  /** Changes the style of the next picture; accumulating styles start with the next events. */
  public void configure(PictureStyle newStyle) {
    style = newStyle;
    painter.configure(newStyle);
    boolean frequency = newStyle.mode() == DisplayMode.FREQUENCY;
    gathered =
        gathered.filter(
            state -> newStyle.mode().gathers() && frequency == state instanceof FrequencyPicture);
    gathered.ifPresent(state -> state.configure(newStyle));
    if (newStyle.mode().gathers() && gathered.isEmpty()) {
      gathered =
          Optional.of(
              frequency
                  ? new FrequencyPicture(frame.geometry(), newStyle)
                  : new EventSums(frame.geometry(), newStyle));
    }
  }

  /** The next event is the first of a new exposure; only sharp styles are cleared. */
  public void beginExposure() {
    if (style.sharp() && style.timeConstantUs() != PictureStyle.ACCUMULATED_US) {
      gathered.ifPresent(StyleState::beginExposure);
    }
  }

  /** The next picture is of its events alone, without smoothing over the pictures before. */
  public void settle() {
    gathered.ifPresent(StyleState::settle);
  }

  @Override
  public void packet(EventPacket packet) {
    frame.packet(packet);
    gathered.ifPresent(state -> state.packet(packet));
  }

  @Override
  public void notified(StreamNotification notification) {
    frame.notified(notification);
    if (notification.restartsTime()) {
      gathered.ifPresent(StyleState::clear);
    }
  }

  /** Advances the picture's time without events. */
  public void advanceTo(long timeUs) {
    frame.advanceTo(timeUs);
  }

  /**
   * Events of a pixel that are painted in the colour of the most, which changes with the scene; 0
   * for styles that do not count.
   */
  public double fullCount() {
    return style.mode() == DisplayMode.COUNTS ? gathered.map(StyleState::fullCount).orElse(0.0) : 0;
  }

  /** Whether no pixel of the last picture flickers, in the style that shows it. */
  public boolean isWithoutFlicker() {
    return gathered.filter(StyleState::isEmpty).isPresent();
  }

  /**
   * Frequency at which a pixel flickers, rows upwards, hertz; NaN if unknown, and for other styles.
   */
  public double frequencyHz(int x, int y) {
    return gathered.map(state -> state.frequencyHz(x, y, frame.nowUs())).orElse(Double.NaN);
  }

  /** How far back events matter to a mode beyond their fading, microseconds. */
  public static long memoryUs(DisplayMode mode) {
    return mode == DisplayMode.FREQUENCY ? FrequencyPicture.MEMORY_US : 0;
  }

  /**
   * Paints for a {@link PictureScaler}: a pixel for each of the sensor's, row by row from the TOP,
   * with its rank in place of its opacity: 0 for the background, 127 for the largest difference
   * from it.
   */
  public void paintRanked(int[] ranked) {
    gathered.ifPresentOrElse(
        state -> state.paint(frame.nowUs(), ranked), () -> painter.paintRanked(frame, ranked));
  }
}
