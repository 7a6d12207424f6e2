package haltere.core.format.internal.decoding;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import java.io.IOException;
import java.util.List;
import java.util.Optional;

/** Estimates an unstated sensor size from all events, so that none is lost. */
public final class SensorGuess {
  private static final int PACKET_EVENTS = 8192;

  /** Usual sensor sizes, the smallest first. Rows count from the top. */
  public static final List<SensorGeometry> COMMON_SIZES =
      List.of(
          top(128, 128),
          top(240, 180),
          top(304, 240),
          top(320, 240),
          top(346, 260),
          top(640, 480),
          top(1280, 720));

  /** Advice for streams without a sensor size. */
  public static final String ADVICE = "state the sensor's size with --sensor WxH";

  private SensorGuess() {}

  /** Extent of the events: right - 1 is the rightmost column. */
  private record Extent(int right, int lowest, int highest) {}

  private static Extent extent(EventCursor cursor) throws IOException {
    EventPacket packet = new EventPacket(PACKET_EVENTS);
    int right = 0;
    int lowest = Integer.MAX_VALUE;
    int highest = 0;
    EventCursor.Stop stop = EventCursor.Stop.MORE;
    while (stop != EventCursor.Stop.END) {
      packet.clear();
      stop = cursor.read(packet, PACKET_EVENTS);
      if (stop == EventCursor.Stop.CLOCK_WENT_BACK) {
        cursor.times().acceptRestart();
      }
      for (int i = 0; i < packet.size(); i++) {
        right = Math.max(right, packet.x(i) + 1);
        lowest = Math.min(lowest, packet.y(i));
        highest = Math.max(highest, packet.y(i) + 1);
      }
    }
    return new Extent(right, lowest, highest);
  }

  /**
   * Reads all events.
   *
   * @param cursor at the start of the recording, with the row numbers of the file
   * @param origin origin of rows in the file
   * @return the smallest sensor with all of their pixels
   * @throws IOException if the file cannot be read
   */
  public static SensorGeometry of(EventCursor cursor, Origin origin) throws IOException {
    Extent extent = extent(cursor);
    return new SensorGeometry(Math.max(1, extent.right()), Math.max(1, extent.highest()), origin);
  }

  /**
   * Origin of rows of a plain table of events: as stated by the file, else by the user, else the
   * top.
   *
   * @param stated origin in the file
   * @param options the user's options
   * @param remarks receives a note if it is not stated
   * @return one of the two
   */
  public static Origin origin(Optional<Origin> stated, ReadOptions options, List<String> remarks) {
    Optional<Origin> known = stated.or(options::origin);
    if (known.isEmpty()) {
      remarks.add("rows are read from the top (--rows bottom changes that)");
    }
    return known.orElse(Origin.TOP);
  }

  /**
   * Chooses a sensor by the events of a recording whose rows count from the top.
   *
   * @param cursor at the first event, opened for {@link #square} of the same side; closed
   *     afterwards
   * @param side of that square
   * @param sizes candidates, the smallest first
   * @return the first that holds the events, or their extent if none does; empty without events
   * @throws IOException if the file cannot be read
   */
  public static Optional<SensorGeometry> smallest(
      EventCursor cursor, int side, List<SensorGeometry> sizes) throws IOException {
    Extent extent;
    try (cursor) {
      extent = extent(cursor);
    }
    if (extent.right() == 0) {
      return Optional.empty();
    }
    int width = extent.right();
    int height = side - extent.lowest();
    return Optional.of(
        sizes.stream()
            .filter(size -> width <= size.width() && height <= size.height())
            .findFirst()
            .orElse(top(width, height)));
  }

  /** Opens a recording's events. */
  @FunctionalInterface
  public interface CursorsBySensor {
    /**
     * Opens the events as those of a sensor.
     *
     * @param sensor of any size; rows count from the top
     * @return a cursor at the first event
     * @throws IOException if the file cannot be read
     */
    EventCursor open(SensorGeometry sensor) throws IOException;
  }

  /**
   * Chooses the smallest usual sensor for the events, with a remark.
   *
   * @param events of the recording
   * @param side maximum columns and rows of the format
   * @param remarks receives a remark on the choice
   * @return a sensor whose rows count from the top; a single pixel without events
   * @throws IOException if the file cannot be read
   */
  public static SensorGeometry usual(CursorsBySensor events, int side, List<String> remarks)
      throws IOException {
    SensorGeometry guess =
        smallest(events.open(square(side)), side, COMMON_SIZES).orElse(top(1, 1));
    remarks.add(remark(guess));
    return guess;
  }

  /**
   * The largest sensor of a format, for finding the extent of the events.
   *
   * @param side columns and rows, within the range of an address
   * @return a sensor whose rows count from the top
   */
  public static SensorGeometry square(int side) {
    return top(side, side);
  }

  /**
   * A sensor whose rows count from the top.
   *
   * @param width columns
   * @param height rows
   * @return the geometry
   */
  public static SensorGeometry top(int width, int height) {
    return new SensorGeometry(width, height, Origin.TOP);
  }

  /**
   * Remark about a choice.
   *
   * @param guess of {@link #smallest}
   * @return one line
   */
  public static String remark(SensorGeometry guess) {
    return "no size is stated; "
        + guess
        + " is the smallest usual one that holds the events (--sensor WxH saves the search)";
  }
}
