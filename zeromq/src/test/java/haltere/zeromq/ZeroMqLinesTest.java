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
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
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
      ZMQ.Socket subscriber = context.createSocket(SocketType.SUB);
      subscriber.connect("tcp://127.0.0.1:" + LineAddress.parse(output.address()).port());
      subscriber.subscribe("wanted/");
      subscriber.setReceiveTimeOut(10);
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

  @Test
  void nobodyNeedBeThere() throws IOException {
    try (LineOutput output = LineOutputs.open("zmq://127.0.0.1:0")) {
      for (int i = 0; i < 20_000; i++) {
        output.send("a/b", LINE);
      }
      assertEquals(-1, output.receivers());
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
