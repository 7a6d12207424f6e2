package haltere.ui.viewer.picture;

import haltere.core.event.EventPacket;
import haltere.core.pipeline.PacketPool;
import haltere.core.stream.internal.Daemon;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A thread that accumulates and paints instead of the chain's thread. It gets copies of packets
 * with their consumers by a {@link PacketPool}, and tasks between them, in order; an empty packet
 * represents a task. If all packets of the pool are waiting, the sender waits.
 *
 * <p>Thread rule: {@link #packet}, {@link #later} and {@link #now} by one thread at a time, {@link
 * #close} by any.
 */
final class PictureThread implements AutoCloseable {
  private static final int PACKETS = 64;
  private static final int PACKET_EVENTS = 4096;
  private static final EventPacket NONE = new EventPacket(0);

  private final PacketPool pool = new PacketPool(PACKETS, PACKET_EVENTS);
  private final ConcurrentLinkedQueue<Consumer<EventPacket>> consumers =
      new ConcurrentLinkedQueue<>();
  private final Thread thread = Daemon.thread(this::work, "haltere-picture");
  private final CompletableFuture<Void> end = new CompletableFuture<>();
  private volatile RuntimeException failure;
  private volatile boolean isClosed;

  PictureThread() {
    thread.start();
  }

  private void work() {
    try {
      while (!isClosed) {
        EventPacket packet = pool.receive();
        guarded(() -> consumers.remove().accept(packet));
        pool.release(packet);
      }
    } catch (InterruptedException closed) {
      Thread.currentThread().interrupt();
    } finally {
      end.completeExceptionally(new CancellationException("closed"));
    }
  }

  private void guarded(Runnable step) {
    try {
      step.run();
    } catch (RuntimeException thrown) {
      failure = thrown;
    } catch (Error thrown) {
      // If this thread died, the chain's thread would wait for ever.
      failure = new IllegalStateException("no picture: " + thrown, thrown);
    }
  }

  /**
   * Sends a copy of a packet to a consumer, or throws the exception of the other thread since the
   * last call.
   */
  void packet(EventPacket packet, Consumer<EventPacket> consumer) {
    rethrowFailure();
    if (!packet.isEmpty()) {
      hand(packet, consumer);
    }
  }

  /** Queues a task after the packets sent so far. */
  void later(Runnable step) {
    rethrowFailure();
    hand(NONE, empty -> step.run());
  }

  private void rethrowFailure() {
    RuntimeException thrown = failure;
    if (thrown != null) {
      failure = null;
      throw thrown;
    }
  }

  private void hand(EventPacket source, Consumer<EventPacket> consumer) {
    try {
      EventPacket copy = pool.take();
      copy.append(source, 0, source.size());
      consumers.add(consumer);
      pool.hand(copy);
    } catch (InterruptedException ending) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Runs a task after the packets sent so far, and waits for it.
   *
   * @throws CancellationException if this is closed before
   */
  <T> T now(Supplier<T> step) {
    CompletableFuture<T> result = CompletableFuture.supplyAsync(step, this::later);
    try {
      CompletableFuture.anyOf(result, end).join();
      return result.join();
    } catch (CompletionException thrown) {
      throw thrown.getCause() instanceof RuntimeException cause ? cause : thrown;
    }
  }

  /** Ends the thread; pending work is discarded. */
  @Override
  public void close() {
    // a task may clear the interruption
    isClosed = true;
    thread.interrupt();
  }
}
