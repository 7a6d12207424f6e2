package haltere.core.format.internal.compression;

/** The bytes of a packet contradict their format. It carries no stack trace: damage is counted. */
public final class DamagedPacketException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * Damage.
   *
   * @param message for developers
   */
  public DamagedPacketException(String message) {
    super(message, null, false, false);
  }
}
