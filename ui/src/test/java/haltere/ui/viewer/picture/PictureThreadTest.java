package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.event.EventPacket;
import haltere.testing.Waiting;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PictureThreadTest {
  /** More than its pool has packets. */
  private static final int MANY = 500;

  private static EventPacket packet(long timeUs) {
    EventPacket packet = new EventPacket(1);
    packet.append(timeUs, 1, 2, true);
    return packet;
  }

  @Test
  void packetsAndStepsAreProcessedInOrder() {
    List<Long> seen = new ArrayList<>();
    try (PictureThread thread = new PictureThread()) {
      List<Long> expected = new ArrayList<>();
      for (long i = 0; i < MANY; i++) {
        long time = i;
        thread.packet(packet(time), packet -> seen.add(packet.firstTimeUs()));
        thread.later(() -> seen.add(-time));
        expected.addAll(List.of(time, -time));
      }
      assertEquals(expected, thread.now(() -> List.copyOf(seen)));
    }
  }

  @Test
  void submittedPacketIsCopied() {
    List<Long> seen = new ArrayList<>();
    try (PictureThread thread = new PictureThread()) {
      EventPacket reused = packet(7);
      thread.packet(reused, packet -> seen.add(packet.firstTimeUs()));
      reused.clear();
      assertEquals(List.of(7L), thread.now(() -> List.copyOf(seen)));
    }
  }

  @Test
  void failureIsReportedAtTheNextCallAndTheThreadContinues() {
    for (Throwable fault : List.of(new IllegalArgumentException("bad"), new StackOverflowError())) {
      try (PictureThread thread = new PictureThread()) {
        thread.later(() -> rethrow(fault));
        assertThrows(
            RuntimeException.class,
            () -> {
              while (true) {
                thread.later(() -> {});
              }
            });
        assertEquals("still there", thread.now(() -> "still there"));
      }
    }
  }

  @Test
  void closingEndsTheThreadAlsoIfAStepClearsItsInterruption() {
    CountDownLatch begun = new CountDownLatch(1);
    PictureThread thread = new PictureThread();
    thread.later(
        () -> {
          begun.countDown();
          while (!Thread.interrupted()) {
            Thread.onSpinWait();
          }
        });
    assertDoesNotThrow(() -> begun.await());
    thread.close();
    Waiting.until("the thread has ended", () -> hasEnded(thread));
  }

  private static boolean hasEnded(PictureThread thread) {
    try {
      thread.now(() -> 1);
      return false;
    } catch (CancellationException closed) {
      return true;
    }
  }

  @Test
  void waitingCallerReceivesTheFailureOfItsStep() {
    try (PictureThread thread = new PictureThread()) {
      IllegalStateException fault = new IllegalStateException("no room");
      assertSame(
          fault,
          assertThrows(
              IllegalStateException.class,
              () ->
                  thread.now(
                      () -> {
                        throw fault;
                      })));
      assertThrows(
          CompletionException.class,
          () ->
              thread.now(
                  () -> {
                    throw new OutOfMemoryError("made up");
                  }));
    }
  }

  @Test
  void waitingCallerIsNotifiedOfTheEndOfTheThread() {
    PictureThread thread = new PictureThread();
    CountDownLatch begun = new CountDownLatch(1);
    thread.later(
        () -> {
          begun.countDown();
          while (!Thread.currentThread().isInterrupted()) {
            LockSupport.park();
          }
        });
    Waiting.until("the step before", () -> begun.getCount() == 0);
    thread.close();
    assertThrows(CancellationException.class, () -> thread.now(() -> "never"));
  }

  private static void rethrow(Throwable fault) {
    if (fault instanceof Error error) {
      throw error;
    }
    throw (RuntimeException) fault;
  }
}
