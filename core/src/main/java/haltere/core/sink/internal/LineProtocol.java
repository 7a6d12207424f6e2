package haltere.core.sink.internal;

import java.io.IOException;
import java.net.Socket;

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

    /** Takes what the peer says from now on, until it leaves; empty if it says nothing. */
    default void listen(Answers answers) throws IOException {}

    /** Whether there is anything to listen to. */
    default boolean speaks() {
      return false;
    }

    /** Whether lines on a topic are for this peer. */
    default boolean wants(byte[] topic) {
      return true;
    }

    /** Whether any lines are for this peer. */
    default boolean receives() {
      return true;
    }
  }

  /** Sends what a peer asked for, in turn with the lines. */
  interface Answers {
    /** Sends some bytes if there is room. */
    void send(byte[] bytes);
  }
}
