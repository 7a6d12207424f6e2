package haltere.filters.trail.internal;

import haltere.core.overlay.MarkStyle.Role;
import haltere.filters.trail.Ellipse;
import java.util.Objects;

/**
 * Drawing of an object at its position.
 *
 * @param role meaning of the outline
 * @param outline its half axes and direction
 * @param isBox whether the outline is the box around the ellipse, rotated with it
 * @param label words
 * @param labelPx distance of the label from the position, to the right and upwards, pixels
 */
public record TrailMark(Role role, Ellipse outline, boolean isBox, String label, double labelPx) {
  /** Nothing may be null. */
  public TrailMark {
    Objects.requireNonNull(role, "role");
    Objects.requireNonNull(outline, "outline");
    Objects.requireNonNull(label, "label");
  }
}
