package haltere.core.sink.internal;

import haltere.core.sink.LiveMessages;
import java.net.Socket;
import java.time.Clock;

/** Sends every line unchanged to each client. */
final class PlainProtocol implements LineProtocol {
  private static final Peer RECEIVER = () -> {};

  @Override
  public byte[] frame(byte[] topic, byte[] line) {
    return line;
  }

  @Override
  public Peer peerOf(Socket socket) {
    return RECEIVER;
  }

  @Override
  public byte[] refusal(String why) {
    return new LiveMessages(Clock.systemUTC()).refused(why);
  }
}
