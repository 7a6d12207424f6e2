package haltere.core.format;

import java.util.Objects;

/**
 * A format's assessment of a file.
 *
 * @param support how sure it is
 * @param reason why, in a few words for users
 * @since 0.1
 */
public record ProbeResult(Support support, String reason) {
  /** Checks that nothing is missing. */
  public ProbeResult {
    Objects.requireNonNull(support, "support");
    Objects.requireNonNull(reason, "reason");
  }
}
