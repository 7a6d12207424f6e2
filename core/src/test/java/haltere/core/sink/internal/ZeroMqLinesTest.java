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
import java.io.DataInputStream;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;

@Timeout(60)
class ZeroMqLinesTest {
  private static final byte[] LINE = "{\"number\":1}\n".getBytes(StandardCharsets.US_ASCII);

  /** What a subscriber says: signature, version 3.0, mechanism NULL, and that it is a SUB. */
  private static final String GREETING =
      "ff00000000000000017f0300"
          + "4e554c4c00000000000000000000000000000000"
          + "0000000000000000000000000000000000000000000000000000000000000000";

  private static final String READY =
      "0419" + "055245414459" + "0b536f636b65742d54797065" + "00000003535542";

  private static final int PUBLISHER_GREETING_BYTES = 64;
  private static final int PUBLISHER_READY_BYTES = 2 + 6 + 12 + 4 + 3;

  private static final int PATIENCE_MS = 30_000;

  /** A subscriber that gets nothing for so long has taken all that was sent. */
  private static final int DRAINED_MS = 100;

  private static int port(LineOutput output) {
    return LineAddress.parse(output.address()).port();
  }

  private static void await(LineOutput output, int receivers) {
    Waiting.until(receivers + " receivers", () -> output.receivers() == receivers);
  }

  private static ZMQ.Socket subscriber(ZContext context, LineOutput output, String topic) {
    ZMQ.Socket subscriber = context.createSocket(SocketType.SUB);
    subscriber.setRcvHWM(1);
    subscriber.setReceiveBufferSize(1);
    subscriber.setReceiveTimeOut(PATIENCE_MS);
    subscriber.connect("tcp://127.0.0.1:" + port(output));
    subscriber.subscribe(topic);
    return subscriber;
  }

  /** A subscriber of bytes, which has been greeted and says some more. */
  private static Socket peer(LineOutput output, String more) throws IOException {
    Socket socket = new Socket("127.0.0.1", port(output));
    socket.getOutputStream().write(HexFormat.of().parseHex(GREETING + READY + more));
    new DataInputStream(socket.getInputStream())
        .readFully(new byte[PUBLISHER_GREETING_BYTES + PUBLISHER_READY_BYTES]);
    return socket;
  }

  private static void expectDisconnection(Socket socket) throws IOException {
    try (socket) {
      while (socket.getInputStream().read() >= 0) {
        // what the publisher says before it hangs up
      }
    } catch (SocketException reset) {
      // hung up as well
    }
  }

  @Test
  void aSubscriberGetsWhatItAskedForAndNothingElse() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZContext context = new ZContext(1)) {
      ZMQ.Socket subscriber = subscriber(context, output, "wanted/");
      await(output, 1);
      byte[] longLine = new byte[1000];
      output.send("other/rows", LINE);
      output.send("wanted/rows", LINE);
      output.send("wanted/rows", longLine);
      assertEquals("wanted/rows", subscriber.recvStr());
      assertEquals("{\"number\":1}\n", subscriber.recvStr());
      assertEquals("wanted/rows", subscriber.recvStr());
      assertArrayEquals(longLine, subscriber.recv());
      assertEquals(0, output.lost());
    }
  }

  @Test
  void aSubscriberThatLeavesIsForgotten() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      try (ZContext context = new ZContext(1)) {
        subscriber(context, output, "");
        await(output, 1);
      }
      await(output, 0);
    }
  }

  @Test
  void nobodyNeedBeThere() throws IOException {
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

  private static void sendAndReceive(LineOutput output, int number, ZMQ.Socket subscriber) {
    output.send("a/b", longLine(number));
    assertEquals("a/b", subscriber.recvStr());
    assertTrue(subscriber.recvStr().startsWith("{\"number\":" + number + ","));
  }

  @Test
  void whatASlowSubscriberMissesIsCountedAndToldAndTheOthersGetAll() throws IOException {
    try (TcpLines output =
            new TcpLines(LineAddress.parse("zmq://127.0.0.1:0"), new ZmtpProtocol(), 16);
        ZContext context = new ZContext(1)) {
      ZMQ.Socket fast = subscriber(context, output, "a/");
      ZMQ.Socket slow = subscriber(context, output, "");
      await(output, 2);
      int sent = 0;
      while (output.lost() < 20) {
        sendAndReceive(output, ++sent, fast);
      }
      long missing = 0;
      long told = 0;
      long last = 0;
      slow.setReceiveTimeOut(DRAINED_MS);
      while (last < sent || told < output.lost()) {
        String topic = slow.recvStr();
        if (topic == null) {
          // what it took made room, and the next line brings the notification
          sendAndReceive(output, ++sent, fast);
          continue;
        }
        Map<?, ?> message = (Map<?, ?>) Json.parse(slow.recvStr(), "a line");
        if (topic.equals("notification")) {
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

  /** What peers say that ends in a frame of 2 GB, or is too long in another way. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "ff000000007fffff0000",
        "ff00000000000000017f010202000000007fffff0078",
        "GET / HTTP/1.1",
        GREETING + "02000000007fffff0000",
        GREETING + "02ffffffffffffffff00",
        GREETING + READY + "02000000007fffff0000",
        // it is a REQ
        GREETING + "0419" + "055245414459" + "0b536f636b65742d54797065" + "00000003524551",
        // a property that is longer than its command
        GREETING + "0419" + "055245414459" + "0b536f636b65742d54797065" + "7fffffff535542",
        GREETING + "0400",
      })
  void aPeerThatIsNoSubscriberIsDisconnectedAndTheOthersReceive(String says) throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZContext context = new ZContext(1)) {
      Socket hostile = new Socket("127.0.0.1", port(output));
      hostile
          .getOutputStream()
          .write(
              says.startsWith("ff")
                  ? HexFormat.of().parseHex(says)
                  : says.getBytes(StandardCharsets.US_ASCII));
      expectDisconnection(hostile);
      ZMQ.Socket subscriber = subscriber(context, output, "");
      await(output, 1);
      output.send("wanted/rows", LINE);
      assertEquals("wanted/rows", subscriber.recvStr());
    }
  }

  @Test
  void aPeerThatDoesNotIntroduceItselfInTimeIsDisconnected() throws IOException {
    try (TcpLines output =
        new TcpLines(LineAddress.parse("zmq://127.0.0.1:0"), new ZmtpProtocol(100), 16)) {
      Socket silent = new Socket("127.0.0.1", port(output));
      silent.getOutputStream().write(0xFF);
      expectDisconnection(silent);
    }
  }

  @Test
  void aPeerWithEndlessSubscriptionsIsDisconnected() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      ByteArrayOutputStream subscriptions = new ByteArrayOutputStream();
      for (int i = 0; i <= ZmtpPeer.MAX_SUBSCRIPTIONS; i++) {
        subscriptions.write(new byte[] {0, 3, 1, (byte) (i >> 8), (byte) i});
      }
      Socket peer = peer(output, "");
      peer.getOutputStream().write(subscriptions.toByteArray());
      expectDisconnection(peer);
      await(output, 0);
    }
  }

  @Test
  void subscriptionsAreMessagesOrCommandsAndCanBeCancelled() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        Socket message = peer(output, "000201" + "61");
        Socket command = peer(output, "040b" + "09535542534352494245" + "61")) {
      await(output, 2);
      message.getOutputStream().write(HexFormat.of().parseHex("000200" + "61"));
      command.getOutputStream().write(HexFormat.of().parseHex("0408" + "0643414e43454c" + "61"));
      await(output, 0);
      output.send("a", LINE);
    }
  }

  @Test
  void aPeerThatAsksWhetherWeAreThereIsAnswered() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        Socket peer = peer(output, "040a" + "0450494e47" + "000a" + "616263")) {
      byte[] answer = new byte[10];
      new DataInputStream(peer.getInputStream()).readFully(answer);
      assertArrayEquals(HexFormat.of().parseHex("0408" + "04504f4e47" + "616263"), answer);
    }
  }

  @Test
  void moreSubscribersThanThereMayBeAreTurnedAwayAndCounted() throws IOException {
    List<Socket> sockets = new ArrayList<>();
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      for (int i = 0; i < TcpLines.MAX_RECEIVERS; i++) {
        sockets.add(peer(output, "000101"));
      }
      await(output, TcpLines.MAX_RECEIVERS);
      Socket late = new Socket("127.0.0.1", port(output));
      expectDisconnection(late);
      assertEquals(1, output.refused());
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }

  @Test
  void aPortThatIsTakenIsSaid() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      String said =
          assertThrows(IOException.class, () -> LineOutputs.open(output.address())).getMessage();
      assertTrue(said.startsWith(output.address() + ": cannot listen here: "), said);
    }
  }
}
