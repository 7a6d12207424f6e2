package haltere.core.sink.internal;

import haltere.core.sink.LineAddress;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;

/**
 * A program that receives live results, on a thread of this one: counts rows, and those that it is
 * told to be missing, and how long each took since it was published.
 */
final class MeasuredReceiver {
  private static final String PUBLISHED = "\"published_ns\":";
  private static final String MISSING = "\"messages\":";
  private static final int DATAGRAM_BYTES = 65_536;
  private static final int BUFFER_BYTES = 4 << 20;

  private final CountDownLatch mayBegin;
  private final long[] tookNanos;
  private volatile long received;
  private volatile long missing;

  private interface Lines {
    void run() throws IOException;
  }

  /**
   * A receiver.
   *
   * @param mayBegin it takes nothing before
   * @param most rows of which the time is kept
   */
  private MeasuredReceiver(CountDownLatch mayBegin, int most) {
    this.mayBegin = mayBegin;
    tookNanos = new long[most];
  }

  /** Connects to where live results are sent from. */
  static MeasuredReceiver connect(String address, CountDownLatch mayBegin, int most)
      throws IOException {
    MeasuredReceiver receiver = new MeasuredReceiver(mayBegin, most);
    LineAddress from = LineAddress.parse(address);
    if (from.scheme().equals("zmq")) {
      receiver.start(() -> receiver.subscribe(address));
    } else {
      Socket socket = new Socket(from.host(), from.port());
      receiver.start(() -> receiver.read(socket));
    }
    return receiver;
  }

  /** Listens for datagrams, at a port that the system chooses. */
  static MeasuredReceiver listen(DatagramSocket socket, int most) {
    MeasuredReceiver receiver = new MeasuredReceiver(new CountDownLatch(0), most);
    receiver.start(() -> receiver.listen(socket));
    return receiver;
  }

  static DatagramSocket datagrams() throws IOException {
    DatagramSocket socket = new DatagramSocket(new InetSocketAddress("127.0.0.1", 0));
    socket.setReceiveBufferSize(BUFFER_BYTES);
    return socket;
  }

  private void start(Lines lines) {
    Thread thread =
        new Thread(
            () -> {
              try {
                mayBegin.await();
                lines.run();
              } catch (IOException | InterruptedException ended) {
                // the end of the measurement
              }
            },
            "receiver");
    thread.setDaemon(true);
    thread.start();
  }

  private void read(Socket socket) throws IOException {
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(socket.getInputStream(), StandardCharsets.US_ASCII), 1 << 16)) {
      for (String line = reader.readLine(); line != null; line = reader.readLine()) {
        take(line);
      }
    }
  }

  private void listen(DatagramSocket socket) throws IOException {
    DatagramPacket packet = new DatagramPacket(new byte[DATAGRAM_BYTES], DATAGRAM_BYTES);
    while (true) {
      socket.receive(packet);
      take(new String(packet.getData(), 0, packet.getLength(), StandardCharsets.US_ASCII));
    }
  }

  private void subscribe(String address) throws IOException {
    try (ZmtpSubscriber subscriber = new ZmtpSubscriber(address, BUFFER_BYTES).to("")) {
      while (true) {
        take(subscriber.receive().line());
      }
    }
  }

  private void take(String line) {
    int at = line.indexOf(PUBLISHED);
    if (at >= 0) {
      long published = number(line, at + PUBLISHED.length());
      if (received < tookNanos.length) {
        tookNanos[(int) received] = System.nanoTime() - published;
      }
      received = received + 1;
    } else if (line.contains("\"lost\"")) {
      missing = missing + number(line, line.indexOf(MISSING) + MISSING.length());
    }
  }

  private static long number(String line, int from) {
    int to = from;
    while (Character.isDigit(line.charAt(to))) {
      to++;
    }
    return Long.parseLong(line, from, to, 10);
  }

  /** Rows that have come. */
  long received() {
    return received;
  }

  /** Messages that it was told to be missing. */
  long missing() {
    return missing;
  }

  /** A share of all rows took at most so many microseconds. */
  double quantileUs(double share) {
    int known = (int) Math.min(received, tookNanos.length);
    long[] sorted = Arrays.copyOf(tookNanos, known);
    Arrays.sort(sorted);
    return known == 0 ? Double.NaN : sorted[(int) Math.min(known - 1, known * share)] / 1e3;
  }
}
