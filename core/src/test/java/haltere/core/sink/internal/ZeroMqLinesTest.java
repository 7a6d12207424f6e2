package haltere.core.sink.internal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputs;
import haltere.testing.Waiting;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
class ZeroMqLinesTest {
  private static final byte[] LINE = "{\"number\":1}\n".getBytes(StandardCharsets.US_ASCII);

  private static final int PATIENCE_MS = 30_000;

  /** A subscriber that gets nothing for so long has taken all that was sent. */
  private static final int DRAINED_MS = 100;

  private static int port(LineOutput output) {
    return LineAddress.parse(output.address()).port();
  }

  private static void await(LineOutput output, int receivers) {
    Waiting.until(receivers + " receivers", () -> output.receivers() == receivers);
  }

  private static ZmtpSubscriber subscriber(LineOutput output, String topic) throws IOException {
    return new ZmtpSubscriber(output).to(topic);
  }

  private static void expectDisconnection(Socket socket) throws IOException {
    socket.setSoTimeout(PATIENCE_MS);
    try (socket) {
      while (socket.getInputStream().read() >= 0) {
        // what the publisher says before it hangs up
      }
    } catch (SocketTimeoutException stillThere) {
      throw stillThere;
    } catch (SocketException reset) {
      // hung up as well
    }
  }

  @Test
  void subscribersReceiveOnlyTheirTopics() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZmtpSubscriber subscriber = subscriber(output, "wanted/")) {
      await(output, 1);
      byte[] longLine = new byte[1000];
      output.send("other/rows", LINE);
      output.send("wanted/rows", LINE);
      output.send("wanted/rows", longLine);
      assertEquals(
          new ZmtpSubscriber.Message("wanted/rows", "{\"number\":1}\n"), subscriber.receive());
      assertEquals(
          new ZmtpSubscriber.Message("wanted/rows", new String(longLine, StandardCharsets.UTF_8)),
          subscriber.receive());
      assertEquals(0, output.lost());
    }
  }

  @Test
  void disconnectedSubscribersAreRemoved() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      ZmtpSubscriber subscriber = subscriber(output, "");
      await(output, 1);
      subscriber.close();
      await(output, 0);
    }
  }

  @Test
  void linesAreAcceptedWithoutSubscribers() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      for (int i = 0; i < 20_000; i++) {
        output.send("a/b", LINE);
      }
      assertEquals(0, output.receivers());
      assertEquals(0, output.lost());
    }
  }

  /** As long as some pages, so that what others than we keep is full soon. */
  private static byte[] longLine(int number) {
    return ("{\"number\":" + number + ",\"row\":\"" + "x".repeat(50_000) + "\"}\n")
        .getBytes(StandardCharsets.US_ASCII);
  }

  private static void sendAndReceive(LineOutput output, int number, ZmtpSubscriber subscriber)
      throws IOException {
    output.send("a/b", longLine(number));
    ZmtpSubscriber.Message message = subscriber.receive();
    assertEquals("a/b", message.topic());
    assertTrue(message.line().startsWith("{\"number\":" + number + ","));
  }

  @Test
  void lossesOfASlowSubscriberAreReportedToItAlone() throws IOException {
    try (TcpLines output =
            new TcpLines(LineAddress.parse("zmq://127.0.0.1:0"), new ZmtpProtocol(), 16);
        ZmtpSubscriber fast = subscriber(output, "a/");
        ZmtpSubscriber slow = subscriber(output, "")) {
      await(output, 2);
      int sent = 0;
      while (output.lost() < 20) {
        sendAndReceive(output, ++sent, fast);
      }
      long missing = 0;
      long told = 0;
      long last = 0;
      while (last < sent || told < output.lost()) {
        Optional<ZmtpSubscriber.Message> next = slow.receive(DRAINED_MS);
        if (next.isEmpty()) {
          // what it took made room, and the next line brings the notification
          sendAndReceive(output, ++sent, fast);
          continue;
        }
        Map<?, ?> message = (Map<?, ?>) Json.parse(next.get().line(), "a line");
        if (next.get().topic().equals("notification")) {
          told += (Long) message.get("messages");
        } else {
          long number = (Long) message.get("number");
          missing += number - last - 1;
          last = number;
        }
      }
      assertEquals(output.lost(), missing);
      assertEquals(output.lost(), told);
    }
  }

  /** Bytes of peers that end in a frame of 2 GB, or are too long in another way. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "ff000000007fffff0000",
        "ff00000000000000017f010202000000007fffff0078",
        "GET / HTTP/1.1",
        ZmtpSubscriber.GREETING + "02000000007fffff0000",
        ZmtpSubscriber.GREETING + "02ffffffffffffffff00",
        ZmtpSubscriber.GREETING + ZmtpSubscriber.READY + "02000000007fffff0000",
        // it is a REQ
        ZmtpSubscriber.GREETING
            + "0419"
            + "055245414459"
            + "0b536f636b65742d54797065"
            + "00000003524551",
        // a property that is longer than its command
        ZmtpSubscriber.GREETING
            + "0419"
            + "055245414459"
            + "0b536f636b65742d54797065"
            + "7fffffff535542",
        ZmtpSubscriber.GREETING + "0400",
      })
  void onlyPeersOtherThanSubscribersAreDisconnected(String says) throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      Socket hostile = new Socket("127.0.0.1", port(output));
      hostile
          .getOutputStream()
          .write(
              says.startsWith("ff")
                  ? HexFormat.of().parseHex(says)
                  : says.getBytes(StandardCharsets.US_ASCII));
      expectDisconnection(hostile);
      try (ZmtpSubscriber subscriber = subscriber(output, "")) {
        await(output, 1);
        output.send("wanted/rows", LINE);
        assertEquals("wanted/rows", subscriber.receive().topic());
      }
    }
  }

  @Test
  void peersWithoutATimelyGreetingAreDisconnected() throws IOException {
    try (TcpLines output =
        new TcpLines(LineAddress.parse("zmq://127.0.0.1:0"), new ZmtpProtocol(100), 16)) {
      Socket silent = new Socket("127.0.0.1", port(output));
      silent.getOutputStream().write(0xFF);
      expectDisconnection(silent);
    }
  }

  @Test
  void peerWithTooManySubscriptionsIsDisconnected() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      ByteArrayOutputStream subscriptions = new ByteArrayOutputStream();
      for (int i = 0; i <= ZmtpPeer.MAX_SUBSCRIPTIONS; i++) {
        subscriptions.write(new byte[] {0, 3, 1, (byte) (i >> 8), (byte) i});
      }
      Socket peer = new ZmtpSubscriber(output).socket();
      peer.getOutputStream().write(subscriptions.toByteArray());
      expectDisconnection(peer);
      await(output, 0);
    }
  }

  @Test
  void subscriptionsAreMessagesOrCommandsAndCanBeCancelled() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZmtpSubscriber message = new ZmtpSubscriber(output);
        ZmtpSubscriber command = new ZmtpSubscriber(output)) {
      message.write("000201" + "61");
      command.write("040b" + "09535542534352494245" + "61");
      await(output, 2);
      message.write("000200" + "61");
      command.write("0408" + "0643414e43454c" + "61");
      await(output, 0);
      output.send("a", LINE);
    }
  }

  @Test
  void pingsAreAnswered() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZmtpSubscriber peer = new ZmtpSubscriber(output)) {
      peer.write("040a" + "0450494e47" + "000a" + "616263");
      assertArrayEquals(HexFormat.of().parseHex("0408" + "04504f4e47" + "616263"), peer.read(10));
    }
  }

  @Test
  void excessSubscribersAreRejectedAndCounted() throws IOException {
    List<ZmtpSubscriber> subscribers = new ArrayList<>();
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      for (int i = 0; i < TcpLines.MAX_RECEIVERS; i++) {
        subscribers.add(subscriber(output, ""));
      }
      await(output, TcpLines.MAX_RECEIVERS);
      Socket late = new Socket("127.0.0.1", port(output));
      expectDisconnection(late);
      assertEquals(1, output.refused());
    } finally {
      for (ZmtpSubscriber subscriber : subscribers) {
        subscriber.close();
      }
    }
  }

  @Test
  void usedPortsAreReported() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      String said =
          assertThrows(IOException.class, () -> LineOutputs.open(output.address())).getMessage();
      assertTrue(said.startsWith(output.address() + ": cannot listen here: "), said);
    }
  }
}
