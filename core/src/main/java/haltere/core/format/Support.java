package haltere.core.format;

/**
 * A format's confidence that a file is its own, from none to certain.
 *
 * @since 0.1
 */
public enum Support {
  /** The content speaks against it. */
  NONE,
  /** Only the file's name speaks for it. */
  EXTENSION_ONLY,
  /** The content looks like it, but other formats' content can too. */
  PLAUSIBLE,
  /** The content says so. */
  CERTAIN
}
