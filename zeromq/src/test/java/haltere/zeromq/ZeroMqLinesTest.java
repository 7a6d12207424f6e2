package haltere.zeromq;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import haltere.core.sink.LineOutputs;
import haltere.testing.ServiceFiles;
import java.io.IOException;
import java.net.Socket;
import java.net.SocketException;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;
import java.util.Optional;
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

  @Test
  void itIsFoundAsAService() {
    assertTrue(
        ServiceFiles.registered(LineOutputProvider.class)
            .containsAll(
                ServiceFiles.implementations(LineOutputProvider.class, ZeroMqLinesProvider.class)));
    assertTrue(LineOutputs.all().containsKey("zmq"));
  }

  @Test
  void aSubscriberGetsWhatItAskedForAndNothingElse() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZContext context = new ZContext(1)) {
      ZMQ.Socket subscriber = subscriber(context, output, "wanted/");
      String topic = null;
      while (topic == null) {
        // who has just connected misses what was sent before
        output.send("other/rows", LINE);
        output.send("wanted/rows", LINE);
        topic = subscriber.recvStr();
      }
      assertEquals("wanted/rows", topic);
      assertEquals("{\"number\":1}\n", subscriber.recvStr());
      assertEquals(0, output.lost());
    }
  }

  /** Connects anew after a second if the handshake fails, instead of after 30 s. */
  private static ZMQ.Socket subscriber(ZContext context, LineOutput output, String topic)
      throws IOException {
    ZMQ.Socket subscriber = context.createSocket(SocketType.SUB);
    subscriber.setHandshakeIvl(1000);
    subscriber.connect("tcp://127.0.0.1:" + LineAddress.parse(output.address()).port());
    subscriber.subscribe(topic);
    subscriber.setReceiveTimeOut(10);
    return subscriber;
  }

  @Test
  void nobodyNeedBeThere() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      for (int i = 0; i < 20_000; i++) {
        output.send("a/b", LINE);
      }
      assertEquals(-1, output.receivers());
    }
  }

  /** Greetings and frames of peers, as hexadecimal numbers, that end in a frame of 2 GB. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "ff000000007fffff0000",
        "ff00000000000000017f010202000000007fffff0078",
      })
  void aPeerThatClaimsALongFrameIsDisconnectedAndTheOthersReceive(String peer) throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0");
        ZContext context = new ZContext(1)) {
      int port = LineAddress.parse(output.address()).port();
      try (Socket hostile = new Socket("127.0.0.1", port)) {
        hostile.getOutputStream().write(HexFormat.of().parseHex(peer));
        hostile.setSoTimeout(30_000);
        while (hostile.getInputStream().read() >= 0) {
          // what the publisher says before it hangs up
        }
      } catch (SocketException reset) {
        // hung up as well
      }
      ZMQ.Socket subscriber = subscriber(context, output, "");
      while (subscriber.recvStr() == null) {
        output.send("wanted/rows", LINE);
      }
      assertEquals(Optional.empty(), output.failure());
    }
  }

  @Test
  void afterAFaultOfTheLibraryNothingIsSentAndAllIsCounted() throws IOException {
    try (ZeroMqLines output = new ZeroMqLines(LineAddress.parse("zmq://127.0.0.1:0"))) {
      output.send("a/b", LINE);
      assertEquals(0, output.lost());
      output.failed(new OutOfMemoryError("Java heap space"));
      output.send("a/b", LINE);
      output.send("a/b", LINE);
      assertEquals(2, output.lost());
      assertTrue(output.failure().orElseThrow().contains("Java heap space"));
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
