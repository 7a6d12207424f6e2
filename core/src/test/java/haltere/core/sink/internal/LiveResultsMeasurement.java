package haltere.core.sink.internal;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.LiveResults;
import haltere.core.sink.LineOutputs;
import java.io.IOException;
import java.net.DatagramSocket;
import java.time.Clock;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Measures live results with receivers in the same program: how many messages a second each way of
 * transport carries without loss, how late they are at 10,000 a second, and what a receiver that
 * takes nothing costs the others and the chain. The argument is how many seconds each takes.
 */
final class LiveResultsMeasurement {
  private static final int PER_MS = 10;
  private static final int IN_FLIGHT = 4096;
  private static final int DATAGRAMS_IN_FLIGHT = 256;
  private static final CountDownLatch AT_ONCE = new CountDownLatch(0);
  private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(20);

  /** A row as wide as that of a track. */
  record Row(
      long published_ns,
      long id,
      double x_px,
      double y_px,
      double vx_px_s,
      double vy_px_s,
      double sd_x_px,
      double sd_y_px,
      double sd_vx_px_s,
      double sd_vy_px_s,
      long events) {}

  /** Publishes what it is told to. */
  private static final class Rows implements EventFilter {
    final Outlet<Row> rows = new Outlet<>("rows", Row.class);
    private long published;
    private long slowestNanos;
    private long spentNanos;

    void publish() {
      double x = (published & 127) + 0.125;
      long begin = System.nanoTime();
      rows.publish(
          new Row(begin, published, x, 64.25, -12.5, 3.75, 0.5, 0.5, 10.25, 9.75, published));
      long took = System.nanoTime() - begin;
      spentNanos += took;
      slowestNanos = Math.max(slowestNanos, took);
      published++;
    }

    @Override
    public void process(EventPacket packet) {}

    @Override
    public void reset() {}

    @Override
    public List<Outlet<?>> outlets() {
      return List.of(rows);
    }
  }

  private final int seconds;

  private LiveResultsMeasurement(int seconds) {
    this.seconds = seconds;
  }

  /**
   * Measures.
   *
   * @param args seconds
   * @throws IOException if a port cannot be had
   */
  public static void main(String[] args) throws IOException {
    LiveResultsMeasurement measurement = new LiveResultsMeasurement(Integer.parseInt(args[0]));
    for (String scheme : List.of("tcp", "udp", "zmq")) {
      measurement.throughput(scheme, 1);
      measurement.throughput(scheme, measurement.seconds);
      measurement.latency(scheme);
    }
    measurement.slowReceiver();
    System.exit(0);
  }

  /** A chain that publishes, and a receiver for it. */
  private final class Bench implements AutoCloseable {
    final Rows rows = new Rows();
    final LiveResults results;
    final MeasuredReceiver receiver;
    private final FilterChain chain = new FilterChain(new SensorGeometry(128, 128));

    Bench(String scheme, int most) throws IOException {
      chain.add("rows", rows);
      if (scheme.equals("udp")) {
        DatagramSocket socket = MeasuredReceiver.datagrams();
        receiver = MeasuredReceiver.listen(socket, most);
        results = open("udp://127.0.0.1:" + socket.getLocalPort());
      } else {
        results = open(scheme + "://127.0.0.1:0");
        receiver = MeasuredReceiver.connect(results.address(), AT_ONCE, most);
      }
      // whoever has just connected misses what was sent before
      while (receiver.received() == 0) {
        rows.publish();
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
      }
    }

    private LiveResults open(String address) throws IOException {
      return LiveResults.open(chain, LineOutputs.open(address), name -> true, Clock.systemUTC());
    }

    @Override
    public void close() {
      results.close();
      chain.close();
    }
  }

  /** Measures the highest rate without loss. */
  private void throughput(String scheme, int duration) throws IOException {
    try (Bench bench = new Bench(scheme, 0)) {
      int inFlight = scheme.equals("udp") ? DATAGRAMS_IN_FLIGHT : IN_FLIGHT;
      long before = bench.receiver.received();
      long offset = bench.rows.published - before;
      long begin = System.nanoTime();
      long end = begin + TimeUnit.SECONDS.toNanos(duration);
      long stuckSince = begin;
      long last = before;
      while (System.nanoTime() < end) {
        long received = bench.receiver.received();
        if (bench.rows.published - offset - received < inFlight) {
          bench.rows.publish();
        } else {
          Thread.onSpinWait();
        }
        if (received != last) {
          last = received;
          stuckSince = System.nanoTime();
        } else if (System.nanoTime() - stuckSince > TimeUnit.SECONDS.toNanos(1)) {
          offset = bench.rows.published - received; // datagrams got lost
        }
      }
      double elapsedS = (System.nanoTime() - begin) / 1e9;
      if (duration == seconds) {
        System.out.printf(
            Locale.ROOT,
            "%s: %,.0f messages a second, %d of %,d lost%n",
            scheme,
            (bench.receiver.received() - before) / elapsedS,
            bench.results.lost(),
            bench.rows.published);
      }
    }
  }

  private void latency(String scheme) throws IOException {
    try (Bench bench = new Bench(scheme, seconds * PER_MS * 1000)) {
      paced(bench.rows);
      print(scheme + ": at 10,000 messages a second", bench.rows, bench.receiver);
    }
  }

  /** Publishes some messages each millisecond. */
  private void paced(Rows rows) {
    rows.slowestNanos = 0;
    rows.spentNanos = 0;
    rows.published = 0;
    long begin = System.nanoTime();
    for (int ms = 0; ms < seconds * 1000; ms++) {
      long due = begin + TimeUnit.MILLISECONDS.toNanos(ms);
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      for (int i = 0; i < PER_MS; i++) {
        rows.publish();
      }
    }
    LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(100));
  }

  private static void print(String what, Rows rows, MeasuredReceiver receiver) {
    System.out.printf(
        Locale.ROOT,
        "%s: half within %.0f us, 99 %% %.0f us, 99.9 %% %.0f us;"
            + " publishing takes the chain %.2f us each, %.0f us at the most%n",
        what,
        receiver.quantileUs(0.5),
        receiver.quantileUs(0.99),
        receiver.quantileUs(0.999),
        rows.spentNanos / 1e3 / rows.published,
        rows.slowestNanos / 1e3);
  }

  /** One that takes nothing until all is published, beside one that takes all. */
  private void slowReceiver() throws IOException {
    try (Bench bench = new Bench("tcp", seconds * PER_MS * 1000)) {
      CountDownLatch published = new CountDownLatch(1);
      MeasuredReceiver slow = MeasuredReceiver.connect(bench.results.address(), published, 0);
      while (bench.results.receivers() < 2) {
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
      }
      long receivedBefore = bench.receiver.received();
      paced(bench.rows);
      published.countDown();
      long end = System.nanoTime() + PATIENCE_NANOS;
      while (slow.missing() + slow.received() < bench.rows.published && System.nanoTime() < end) {
        bench.rows.publish(); // what is missing is told with the next that has room
        LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
      }
      print("tcp: beside a receiver that takes nothing", bench.rows, bench.receiver);
      System.out.printf(
          Locale.ROOT,
          "the slow one got %,d and was told that %,d are missing, of %,d; the other got %,d%n",
          slow.received(),
          slow.missing(),
          bench.rows.published,
          bench.receiver.received() - receivedBefore);
    }
  }
}
