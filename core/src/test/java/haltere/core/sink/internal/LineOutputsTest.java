package haltere.core.sink.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import haltere.core.sink.LineAddress;
import haltere.core.sink.LineOutput;
import haltere.core.sink.LineOutputProvider;
import haltere.core.sink.LineOutputs;
import haltere.testing.ServiceFiles;
import haltere.testing.Waiting;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class LineOutputsTest {
  private static byte[] line(int number) {
    return ("{\"number\":" + number + "}\n").getBytes(StandardCharsets.US_ASCII);
  }

  private static Socket connect(LineOutput output) throws IOException {
    Socket socket = new Socket("127.0.0.1", LineAddress.parse(output.address()).port());
    Waiting.until("a receiver", () -> output.receivers() > 0);
    return socket;
  }

  private static BufferedReader reader(Socket socket) throws IOException {
    return new BufferedReader(
        new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII));
  }

  @Test
  void serviceFileNamesEveryProvider() {
    assertTrue(
        ServiceFiles.registered(LineOutputProvider.class)
            .containsAll(
                ServiceFiles.implementations(LineOutputProvider.class, LineOutputs.class)));
    assertTrue(LineOutputs.all().keySet().containsAll(List.of("tcp", "udp", "zmq")));
    LineOutputs.all().forEach((scheme, way) -> assertTrue(way.description().endsWith(".")));
  }

  @Test
  void addressConsistsOfTransportHostAndPort() {
    assertEquals(new LineAddress("tcp", "::1", 80), LineAddress.parse("tcp://[::1]:80"));
    assertEquals("udp://[::1]:80", LineAddress.parse("udp://[::1]:80").toString());
    assertEquals(new LineAddress("zmq", "*", 5), LineAddress.parse("zmq://*:5/"));
    for (String wrong :
        List.of("", "tcp", "tcp://", "tcp://a", "tcp://a:b", "tcp://a:65536", "a:5", "://a:5")) {
      assertThrows(IllegalArgumentException.class, () -> LineAddress.parse(wrong), wrong);
    }
    String said =
        assertThrows(IllegalArgumentException.class, () -> LineOutputs.check("pigeon://a:5"))
            .getMessage();
    assertEquals("pigeon://a:5: there is no pigeon://; there are tcp, udp, zmq", said);
  }

  @Test
  void connectedReceiversGetEveryLine() throws IOException {
    LineOutput output = LineOutputs.open("tcp://127.0.0.1:0");
    try (Socket first = connect(output);
        Socket second = new Socket("127.0.0.1", first.getPort())) {
      Waiting.until("two receivers", () -> output.receivers() == 2);
      for (int i = 0; i < 100; i++) {
        output.send("a/b", line(i));
      }
      output.close();
      for (Socket socket : List.of(first, second)) {
        List<String> lines = reader(socket).lines().toList();
        assertEquals(100, lines.size());
        assertEquals("{\"number\":99}", lines.get(99));
      }
      assertEquals(0, output.lost());
    }
  }

  @Test
  void slowReceiversLoseCountedLinesAndAreNotified() throws IOException {
    TcpLines output = new TcpLines(LineAddress.parse("tcp://127.0.0.1:0"), new PlainProtocol(), 16);
    try (Socket socket = connect(output);
        BufferedReader reader = reader(socket)) {
      int sent = 0;
      byte[] filler = line(1_000_000_000);
      while (output.lost() < 100) {
        output.send("a/b", filler);
        sent++;
      }
      long whole = 0;
      long missing = 0;
      boolean told = false;
      while (!told) {
        // what it takes makes room, and the next line brings the notification
        Map<?, ?> message = (Map<?, ?>) Json.parse(reader.readLine(), "a line");
        if (message.get("notification") == null) {
          whole++;
        } else {
          missing += (Long) message.get("messages");
          told = true;
        }
        output.send("a/b", filler);
        sent++;
      }
      output.close();
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        Map<?, ?> message = (Map<?, ?>) Json.parse(line, "a line");
        if (message.get("notification") == null) {
          whole++;
        } else {
          missing += (Long) message.get("messages");
        }
      }
      assertEquals(missing, output.lost());
      assertEquals(sent, whole + missing);
    }
  }

  @Test
  void disconnectedReceiversAreRemoved() throws IOException {
    try (LineOutput output = LineOutputs.open("tcp://127.0.0.1:0")) {
      Socket socket = connect(output);
      socket.setSoLinger(true, 0);
      socket.close();
      while (output.receivers() > 0) {
        output.send("a/b", line(1));
      }
      assertEquals(0, output.receivers());
    }
  }

  @Test
  void closingDoesNotWaitForAStalledReceiver() throws IOException {
    TcpLines output = new TcpLines(LineAddress.parse("tcp://127.0.0.1:0"), new PlainProtocol(), 16);
    try (Socket socket = connect(output)) {
      while (output.lost() == 0) {
        output.send("a/b", new byte[4096]);
      }
      long begin = System.nanoTime();
      output.close();
      assertTrue(System.nanoTime() - begin < Duration.ofSeconds(10).toNanos());
      assertTrue(socket.isConnected());
    }
  }

  @Test
  void usedPortsAreReported() throws IOException {
    try (LineOutput output = LineOutputs.open("tcp://127.0.0.1:0")) {
      String address = output.address();
      String said = assertThrows(IOException.class, () -> LineOutputs.open(address)).getMessage();
      assertTrue(said.startsWith(address + ": cannot listen here: "), said);
    }
  }

  @Test
  void eachLineIsADatagram() throws IOException {
    try (DatagramSocket receiver = new DatagramSocket(0, InetAddress.getByName("127.0.0.1"));
        LineOutput output = LineOutputs.open("udp://127.0.0.1:" + receiver.getLocalPort())) {
      output.send("a/b", line(1));
      output.send("a/b", line(2));
      DatagramPacket packet = new DatagramPacket(new byte[1000], 1000);
      receiver.receive(packet);
      receiver.receive(packet);
      assertEquals(
          "{\"number\":2}\n",
          new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII));
      assertEquals(0, output.lost());
    }
    assertThrows(IllegalArgumentException.class, () -> LineOutputs.check("udp://127.0.0.1:0"));
  }

  @Test
  void oversizedDatagramsAreCounted() throws IOException {
    try (LineOutput output = LineOutputs.open("udp://127.0.0.1:9")) {
      output.send("a/b", new byte[70_000]);
      assertEquals(1, output.lost());
    }
  }

  @Test
  void excessReceiversAreNotifiedAndDisconnected() throws IOException {
    List<Socket> sockets = new ArrayList<>();
    try (LineOutput output = LineOutputs.open("tcp://127.0.0.1:0")) {
      int port = LineAddress.parse(output.address()).port();
      for (int i = 0; i < TcpLines.MAX_RECEIVERS; i++) {
        sockets.add(new Socket("127.0.0.1", port));
      }
      Socket late = new Socket("127.0.0.1", port);
      sockets.add(late);
      List<String> lines = reader(late).lines().toList();
      assertEquals(1, lines.size());
      assertTrue(lines.get(0).contains("\"notification\":\"refused\""), lines.get(0));
      assertEquals(1, output.refused());
      assertEquals(TcpLines.MAX_RECEIVERS, output.receivers());
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
    }
  }
}
