package haltere.filters.wing;

import java.util.Objects;
import java.util.Optional;

/**
 * A manual change of a running Kalman filter of a wing.
 *
 * @param part the wing, or the edge with a filter for each edge
 * @param edit the changed number; empty for a restart
 */
public record ManualWingChange(WingPart part, Optional<WingFilterEdit> edit) implements WingResult {
  public ManualWingChange {
    Objects.requireNonNull(part, "part");
    Objects.requireNonNull(edit, "edit");
  }
}
