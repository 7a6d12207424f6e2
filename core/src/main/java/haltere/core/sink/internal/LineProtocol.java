package haltere.core.sink.internal;

import java.io.IOException;
import java.net.Socket;
import java.util.function.Consumer;

/**
 * Protocol of the TCP connections of an output.
 *
 * <p>Thread rule: any thread.
 */
interface LineProtocol {
  /** The bytes of a line as sent to receivers. */
  byte[] frame(byte[] topic, byte[] line);

  /** A newly connected client. */
  Peer peerOf(Socket socket) throws IOException;

  /** Message to a refused client before the connection is closed. */
  byte[] refusal(String why);

  /** The other end of a connection. */
  interface Peer {
    /** Exchanges the data before the first line; throws for a peer that is not a receiver. */
    void greet() throws IOException;

    /**
     * Processes the data of the peer until it disconnects.
     *
     * @param answers sends answers, in turn with the lines and if there is room
     */
    default void listen(Consumer<byte[]> answers) throws IOException {}

    /**
     * Whether the peer sends data.
     *
     * @return the same at all times
     */
    default boolean sendsData() {
      return false;
    }

    /**
     * Whether lines on a topic are for this peer.
     *
     * @param topic as sent over the connection
     * @return whether it subscribed to them
     */
    default boolean wants(byte[] topic) {
      return true;
    }

    /**
     * Whether any lines are for this peer.
     *
     * @return whether it has a subscription
     */
    default boolean receives() {
      return true;
    }
  }
}
