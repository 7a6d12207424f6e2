package haltere.device.usb;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import haltere.core.camera.CameraOptions.WhenFull;
import haltere.device.protocol.Dvs128Decoder;
import java.io.InterruptedIOException;
import java.nio.IntBuffer;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Buffers that wait for a consumer, and the thread that handles bus events meanwhile. */
@Timeout(60)
class ReceivedBuffersTest {
  private static final int WAITING = 64;
  private static final long MS = TimeUnit.MILLISECONDS.toNanos(1);
  private static final long LONG = TimeUnit.SECONDS.toNanos(50);
  private static final int EVENTS = 3;

  private static ReceivedBuffers buffers(WhenFull whenFull, BusWork work) {
    return new ReceivedBuffers(
        1, WAITING, 64, whenFull, new Dvs128Decoder(false)::droppedWords, work);
  }

  /** A transfer comes each 10 ms; returns what the next will fill. */
  private static Received fill(ReceivedBuffers buffers, int transfers) {
    Received filling = buffers.spare();
    for (int i = 0; i < transfers; i++) {
      filling.filled(TransferEnd.COMPLETED, EVENTS * Integer.BYTES, i * 10 * MS);
      filling = buffers.arrived(filling);
    }
    return filling;
  }

  @Test
  void dropOldestDiscardsAndCountsBuffersOlderThanHalfASecond() throws Exception {
    ReceivedBuffers buffers = buffers(WhenFull.DROP_OLDEST, BusWork.ELSEWHERE);
    fill(buffers, 60);

    assertEquals(51, buffers.counts().waiting());
    assertEquals(9 * EVENTS, buffers.counts().lostEvents());
    Received oldest = buffers.take(0);
    assertEquals(90 * MS, oldest.arrivedNanos());
    assertEquals(9, oldest.before().transfers());
    assertEquals(9 * EVENTS, oldest.before().events());
  }

  @Test
  void dropOldestKeepsOnlyTheNewestBufferAfterALongPause() throws Exception {
    ReceivedBuffers buffers = buffers(WhenFull.DROP_OLDEST, BusWork.ELSEWHERE);
    Received filling = fill(buffers, 5);
    filling.filled(TransferEnd.COMPLETED, EVENTS * Integer.BYTES, 10_000 * MS);
    buffers.arrived(filling);

    Received only = buffers.take(0);
    assertSame(filling, only);
    assertEquals(5 * EVENTS, only.before().events());
    assertNull(buffers.take(0));
  }

  @Test
  void dropNewestKeepsWaitingBuffersWithoutTimeLimit() {
    ReceivedBuffers buffers = buffers(WhenFull.DROP_NEWEST, BusWork.ELSEWHERE);
    fill(buffers, 60);

    assertEquals(60, buffers.counts().waiting());
    assertEquals(0, buffers.counts().lostEvents());
  }

  /** A bus on which nothing happens but what a consumer does. */
  private static final class ByConsumer implements BusWork {
    private final Semaphore interrupted = new Semaphore(0);
    private final CountDownLatch waiting = new CountDownLatch(1);
    private Runnable happening;

    @Override
    public boolean doFor(long nanos, IntBuffer noMore) {
      if (noMore.get(0) != 0) {
        return true;
      }
      if (happening != null) {
        happening.run();
        happening = null;
      } else if (nanos > 0) {
        waiting.countDown();
        interrupted.acquireUninterruptibly();
      }
      return true;
    }

    @Override
    public void interrupt() {
      interrupted.release();
    }
  }

  @Test
  void waitingConsumerHandlesBusEventsItself() throws InterruptedIOException {
    ByConsumer work = new ByConsumer();
    ReceivedBuffers buffers = buffers(WhenFull.DROP_NEWEST, work);
    work.happening = () -> fill(buffers, 2);

    assertNotNull(buffers.take(LONG));
    assertNotNull(buffers.take(0));
    assertNull(buffers.take(0), "it has worked once, and nothing has come since");
  }

  @Test
  void consumerWithWaitingBuffersHandlesBusEventsFirst() throws InterruptedIOException {
    ByConsumer work = new ByConsumer();
    ReceivedBuffers buffers = buffers(WhenFull.DROP_NEWEST, work);
    Received filling = fill(buffers, 1);
    work.happening =
        () -> {
          filling.filled(TransferEnd.COMPLETED, Integer.BYTES, 10 * MS);
          buffers.arrived(filling);
        };

    assertEquals(0, buffers.take(0).arrivedNanos());
    assertEquals(10 * MS, buffers.take(0).arrivedNanos());
  }

  @Test
  void endWakesAConsumerThatHandlesBusEvents() throws Exception {
    ByConsumer work = new ByConsumer();
    ReceivedBuffers buffers = buffers(WhenFull.DROP_NEWEST, work);
    CompletableFuture<Received> taken =
        CompletableFuture.supplyAsync(
            () -> {
              try {
                return buffers.take(LONG);
              } catch (InterruptedIOException problem) {
                throw new AssertionError(problem);
              }
            });
    work.waiting.await();
    buffers.end();

    assertNull(taken.get());
  }
}
