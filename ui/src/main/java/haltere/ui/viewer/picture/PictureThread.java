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
 * A thread that gathers and paints, so that the thread of the chain need not. It gets copies of
 * packets by way of a {@link PacketPool} with who takes each, and steps to take between them, in
 * order; an empty packet stands for each step. Where it falls behind by all packets of the pool,
 * who hands one over waits.
 *
 * <p>Thread rule: {@link #packet}, {@link #later} and {@link #now} by one thread at a time, {@link
 * #close} by any.
 */
final class PictureThread implements AutoCloseable {
  private static final int PACKETS = 64;
  private static final int PACKET_EVENTS = 4096;
  private static final EventPacket NONE = new EventPacket(0);

  private final PacketPool pool = new PacketPool(PACKETS, PACKET_EVENTS);
  private final ConcurrentLinkedQueue<Consumer<EventPacket>> takers = new ConcurrentLinkedQueue<>();
  private final Thread thread = Daemon.thread(this::work, "haltere-picture");
  private final CompletableFuture<Void> end = new CompletableFuture<>();
  private volatile RuntimeException failure;

  /** Begins; packets are taken on the new thread. */
  PictureThread() {
    thread.start();
  }

  private void work() {
    try {
      while (true) {
        EventPacket packet = pool.receive();
        guarded(() -> takers.remove().accept(packet));
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
      // A thread that died of it would let the chain's thread wait for ever.
      failure = new IllegalStateException("no picture: " + thrown, thrown);
    }
  }

  /**
   * Hands over a copy of a packet to who takes it, or throws what was thrown on the other thread
   * since the last call.
   */
  void packet(EventPacket packet, Consumer<EventPacket> taker) {
    tellFailure();
    if (!packet.isEmpty()) {
      hand(packet, taker);
    }
  }

  /** Does something behind the packets that were handed over, and does not wait for it. */
  void later(Runnable step) {
    tellFailure();
    hand(NONE, empty -> step.run());
  }

  private void tellFailure() {
    RuntimeException thrown = failure;
    if (thrown != null) {
      failure = null;
      throw thrown;
    }
  }

  private void hand(EventPacket source, Consumer<EventPacket> taker) {
    try {
      EventPacket copy = pool.take();
      copy.append(source, 0, source.size());
      takers.add(taker);
      pool.hand(copy);
    } catch (InterruptedException ending) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * Does something behind the packets that were handed over, and waits for it.
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

  /** Ends the thread; what it has not come to is left out. */
  @Override
  public void close() {
    thread.interrupt();
  }
}
