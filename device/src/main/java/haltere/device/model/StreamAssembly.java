package haltere.device.model;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.device.protocol.DroppedWords;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.Received;
import haltere.device.usb.ReceivedBuffers;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Collection;

/**
 * Creates the stream of one connection from its buffers: packets, samples and notifications, in
 * order. {@link DataLost} precedes the data after a loss.
 *
 * <p>Thread rule: the consumer's thread.
 */
final class StreamAssembly {
  private static final int PACKET_EVENTS = 8192;
  private static final long UNKNOWN = -1;

  private final ReceivedBuffers buffers;
  private final WireDecoder decoder;
  private final Runnable recover;
  private final String camera;
  private final boolean samples;
  private final LatencyHistogram latency;
  private final ClockWatch clock;
  private final EventPacket packet = new EventPacket(PACKET_EVENTS);
  private final EventPacket nothing = new EventPacket(1);

  /** Pending elements: the packet, samples, notifications. */
  private final ArrayDeque<Object> ready = new ArrayDeque<>();

  private Received current;
  private ByteBuffer input;
  private boolean finished;
  private long lastUs = StreamNotification.NO_TIME_US;
  private boolean losing;
  private long lostBytes;
  private long lostEvents;
  private boolean losingUnknown;
  private boolean clockReset;

  /**
   * The stream of a connection.
   *
   * @param buffers received data
   * @param decoder of a new stream
   * @param recover called after a failed transfer
   * @param camera its name, for users
   * @param samples whether samples are passed on
   * @param latency receives the latency of each buffer
   * @param clock receives times
   */
  StreamAssembly(
      ReceivedBuffers buffers,
      WireDecoder decoder,
      Runnable recover,
      String camera,
      boolean samples,
      LatencyHistogram latency,
      ClockWatch clock) {
    this.buffers = buffers;
    this.decoder = decoder;
    this.recover = recover;
    this.camera = camera;
    this.samples = samples;
    this.latency = latency;
    this.clock = clock;
  }

  long lastUs() {
    return lastUs;
  }

  boolean isReady() {
    return !ready.isEmpty();
  }

  /** Passes on the next packet, notification or sample; returns its number of events. */
  int handOver(StreamHandler handler) {
    Object next = ready.remove();
    if (next == packet) {
      int events = packet.size();
      handler.packet(packet);
      return events;
    }
    if (next instanceof SensorSample sample) {
      handler.sample(sample);
    } else {
      handler.notified((StreamNotification) next);
    }
    return 0;
  }

  /** Passes on the pending notifications. */
  void drainTo(Collection<StreamNotification> notifications) {
    ready.forEach(next -> notifications.add((StreamNotification) next));
    ready.clear();
  }

  /**
   * Decodes buffers until something can be passed on.
   *
   * @param nanos longest wait for a buffer
   * @return false after a timeout or at the end
   */
  boolean advance(long nanos) throws InterruptedIOException {
    if (current == null) {
      Received next = buffers.take(nanos);
      if (next == null) {
        return false;
      }
      begin(next);
    }
    packet.clear();
    WireDecoder.Stop stop = decoder.decode(input, packet, PACKET_EVENTS);
    if (!packet.isEmpty()) {
      reportLoss(packet.firstTimeUs());
      lastUs = packet.lastTimeUs();
      ready.add(packet);
    }
    switch (stop) {
      case SAMPLE -> {
        reportLoss(decoder.sample().timeUs());
        if (samples) {
          ready.add(decoder.sample());
        }
      }
      case CLOCK_RESET -> resetClock();
      case INPUT_USED -> finish();
      case PACKET_FULL -> {}
    }
    return true;
  }

  private void begin(Received next) {
    current = next;
    input = next.bytes();
    if (!next.before().isEmpty()) {
      skip(next.before());
    }
  }

  /** Advances the decoder over dropped words. */
  void skip(DroppedWords dropped) {
    lostBytes += dropped.bytes();
    lostEvents += dropped.events();
    losing |= dropped.transfers() > 0;
    if (dropped.isUnknown()) {
      decoder.breakOffUnknown(); // the bytes may be missing before any of the summarised words
    }
    decoder.breakOff();
    dropped.replay(
        words -> {
          while (words.hasRemaining()) {
            nothing.clear();
            clockReset |= decoder.decode(words, nothing, 1) == WireDecoder.Stop.CLOCK_RESET;
          }
        });
    if (dropped.isUnknown()) {
      loseUnknown();
    }
  }

  private void loseUnknown() {
    losingUnknown = true;
    decoder.breakOffUnknown();
    recover.run();
  }

  /** Adds notifications of counted and uncounted losses before the next data. */
  void reportLoss(long nextUs) {
    if (losing) {
      String place = "buffers of " + camera + " were not consumed in time";
      ready.add(new DataLost(lostBytes, lostEvents, lastUs, nextUs, place));
      losing = false;
      lostBytes = 0;
      lostEvents = 0;
    }
    if (losingUnknown) {
      String place = "a transfer from " + camera + " failed";
      ready.add(new DataLost(UNKNOWN, UNKNOWN, lastUs, nextUs, place));
      losingUnknown = false;
    }
    if (clockReset) {
      ready.add(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, nextUs));
      clockReset = false;
      clock.restart();
    }
  }

  private void resetClock() {
    reportLoss(StreamNotification.NO_TIME_US);
    ready.add(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, StreamNotification.NO_TIME_US));
    lastUs = StreamNotification.NO_TIME_US;
    clock.restart();
  }

  /** Marks a buffer as decoded; it is released when its content has been passed on. */
  private void finish() {
    if (lastUs != StreamNotification.NO_TIME_US) {
      clock.note(lastUs, current.arrivedNanos());
    }
    switch (current.end()) {
      case COMPLETED, GONE -> {}
      default -> loseUnknown();
    }
    finished = true;
    if (ready.isEmpty()) {
      release();
    }
  }

  /** Releases the decoded buffer, if there is one. */
  void release() {
    if (finished) {
      finished = false;
      latency.add(System.nanoTime() - current.arrivedNanos());
      Received done = current;
      current = null;
      buffers.release(done);
    }
  }
}
