package haltere.core.format;

import java.util.Objects;

/**
 * A format's assessment of a file.
 *
 * @param support its confidence
 * @param reason the reason, in a few words for users
 * @since 0.1
 */
public record ProbeResult(Support support, String reason) {
  /** Checks that neither is null. */
  public ProbeResult {
    Objects.requireNonNull(support, "support");
    Objects.requireNonNull(reason, "reason");
  }
}
