package haltere.core.format;

/**
 * A format's confidence that a file is its own, from none to certain.
 *
 * @since 0.1
 */
public enum Support {
  /** The content contradicts the format. */
  NONE,
  /** Only the file's name matches. */
  EXTENSION_ONLY,
  /** The content matches, but other formats may match too. */
  PLAUSIBLE,
  /** The content identifies the format. */
  CERTAIN
}
