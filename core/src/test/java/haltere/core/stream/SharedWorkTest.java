package haltere.core.stream;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import java.util.Arrays;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class SharedWorkTest {
  @Test
  void everyPieceRunsOnce() {
    try (SharedWork work = new SharedWork(2)) {
      for (int round = 0; round < 20_000; round++) {
        int[] done = new int[round % 7];
        work.each(done.length, piece -> done[piece]++);
        int[] expected = new int[done.length];
        Arrays.fill(expected, 1);
        assertArrayEquals(expected, done);
      }
    }
  }

  @Test
  void twoPiecesRunConcurrentlyOnTwoThreads() {
    AtomicReferenceArray<Thread> threads = new AtomicReferenceArray<>(2);
    CountDownLatch both = new CountDownLatch(2);
    try (SharedWork work = new SharedWork(2)) {
      work.each(
          2,
          piece -> {
            threads.set(piece, Thread.currentThread());
            both.countDown();
            await(both);
          });
    }
    assertNotSame(threads.get(0), threads.get(1));
  }

  @Test
  void singleThreadRunsPiecesInOrder() {
    Thread caller = Thread.currentThread();
    StringBuilder order = new StringBuilder();
    SharedWork.ALONE.each(
        3,
        piece -> {
          assertSame(caller, Thread.currentThread());
          order.append(piece);
        });
    assertEquals("012", order.toString());
  }

  @Test
  void exceptionsOfPiecesReachTheCallerAfterAllPieces() {
    for (int throwing = 0; throwing < 2; throwing++) {
      int bad = throwing;
      CountDownLatch both = new CountDownLatch(2);
      AtomicInteger atWork = new AtomicInteger();
      try (SharedWork work = new SharedWork(2)) {
        IllegalStateException thrown =
            assertThrows(
                IllegalStateException.class,
                () ->
                    work.each(
                        2,
                        piece -> {
                          atWork.incrementAndGet();
                          both.countDown();
                          await(both);
                          atWork.decrementAndGet();
                          if (piece == bad) {
                            throw new IllegalStateException("piece " + piece);
                          }
                        }));
        assertEquals("piece " + bad, thrown.getMessage());
        assertEquals(0, atWork.get());
        int[] done = new int[2];
        work.each(2, piece -> done[piece]++);
        assertArrayEquals(new int[] {1, 1}, done);
      }
    }
  }

  @Test
  void closingEndsTheThreadAndWorkContinuesWithoutIt() throws InterruptedException {
    Thread[] second = new Thread[1];
    Thread caller = Thread.currentThread();
    CountDownLatch both = new CountDownLatch(2);
    SharedWork work = new SharedWork(2);
    work.each(
        2,
        piece -> {
          if (Thread.currentThread() != caller) {
            second[0] = Thread.currentThread();
          }
          both.countDown();
          await(both);
        });
    work.close();
    second[0].join();
    assertFalse(second[0].isAlive());
    int[] done = new int[3];
    work.each(3, piece -> done[piece]++);
    assertArrayEquals(new int[] {1, 1, 1}, done);
  }

  @Test
  void sortedEventsReachTheirPartOnceAndInOrder() {
    StringBuilder[] seen = {new StringBuilder(), new StringBuilder()};
    EventQueues queues =
        new EventQueues(
            2,
            (part, events) -> {
              for (int i = 0; i < events.size(); i++) {
                seen[part].append(events.timeUs(i)).append(' ');
              }
            });
    try (SharedWork work = new SharedWork(2)) {
      queues.share(work);
      for (int i = 0; i < 9; i++) {
        queues.add(i % 2, i, EventAddress.pack(i, 0, true));
        if (i == 4) {
          queues.process();
        }
      }
      queues.process();
      queues.process();
    }
    assertEquals("0 2 4 6 8 ", seen[0].toString());
    assertEquals("1 3 5 7 ", seen[1].toString());
  }

  @Test
  void moreThanTwoThreadsAreRejected() {
    String message =
        assertThrows(IllegalArgumentException.class, () -> new SharedWork(3)).getMessage();
    assertTrue(message.contains("1 or 2"), message);
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
