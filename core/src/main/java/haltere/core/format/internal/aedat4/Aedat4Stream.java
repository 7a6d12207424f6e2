package haltere.core.format.internal.aedat4;

import java.util.Map;
import java.util.Optional;

/**
 * A stream of an AEDAT-4 file.
 *
 * @param id stream number in its packets
 * @param type four letters: {@code EVTS}, {@code FRME}, {@code IMUS}, {@code TRIG} and others
 * @param width of the sensor, 0 if it is not stated
 * @param height of the sensor, 0 if it is not stated
 * @param module module of the writing program, such as {@code capture} or {@code jAER}
 * @param source the camera
 * @param metadata of the camera and the chain in recordings of this program, by key
 */
public record Aedat4Stream(
    int id,
    String type,
    int width,
    int height,
    Optional<String> module,
    Optional<String> source,
    Map<String, String> metadata) {
  static final String EVENTS = "EVTS";

  /** Copies. */
  public Aedat4Stream {
    metadata = Map.copyOf(metadata);
  }

  /**
   * Whether it holds polarity events.
   *
   * @return true for {@code EVTS}
   */
  public boolean isEvents() {
    return type.equals(EVENTS);
  }

  /** jAER counts rows from the bottom and names itself. */
  boolean countsRowsFromBottom() {
    return module.isPresent() && module.get().equalsIgnoreCase("jAER");
  }
}
