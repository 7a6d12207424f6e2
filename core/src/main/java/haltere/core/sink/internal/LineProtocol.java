package haltere.core.sink.internal;

import java.io.IOException;
import java.net.Socket;
import java.util.function.Consumer;

/**
 * What is said on the TCP connections of an output.
 *
 * <p>Thread rule: any thread.
 */
interface LineProtocol {
  /** The bytes of a line as receivers get them. */
  byte[] frame(byte[] topic, byte[] line);

  /** One who has just connected. */
  Peer meet(Socket socket) throws IOException;

  /** What may be sent to one that is turned away, before the connection is closed. */
  byte[] refusal(String why);

  /** The other end of a connection. */
  interface Peer {
    /**
     * Sends and awaits what precedes the first line; refuses, by an exception, who is no receiver.
     */
    void greet() throws IOException;

    /**
     * Takes what the peer says from now on, until it leaves; nothing if it does not speak.
     *
     * @param answers sends what the peer asked for, in turn with the lines and if there is room
     */
    default void listen(Consumer<byte[]> answers) throws IOException {}

    /**
     * Whether there is anything to listen to.
     *
     * @return the same at all times
     */
    default boolean speaks() {
      return false;
    }

    /**
     * Whether lines on a topic are for this peer.
     *
     * @param topic as it goes over the connection
     * @return whether it asked for them
     */
    default boolean wants(byte[] topic) {
      return true;
    }

    /**
     * Whether any lines are for this peer.
     *
     * @return whether it asked for some
     */
    default boolean receives() {
      return true;
    }
  }
}
