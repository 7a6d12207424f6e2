package haltere.filters.wing;

import java.util.Objects;
import java.util.Optional;

/**
 * What a person did to a Kalman filter of a wing while it ran.
 *
 * @param part the wing, or the edge where there is a filter for each edge
 * @param edit the number that was changed; empty where the filter was begun anew
 */
public record WingByHand(WingPart part, Optional<WingFilterEdit> edit) implements WingResult {
  public WingByHand {
    Objects.requireNonNull(part, "part");
    Objects.requireNonNull(edit, "edit");
  }
}
