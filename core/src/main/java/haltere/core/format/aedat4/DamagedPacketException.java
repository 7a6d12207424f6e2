package haltere.core.format.aedat4;

/** The bytes of a packet contradict their format. It carries no stack trace: damage is counted. */
final class DamagedPacketException extends Exception {
  private static final long serialVersionUID = 1L;

  DamagedPacketException(String message) {
    super(message, null, false, false);
  }
}
