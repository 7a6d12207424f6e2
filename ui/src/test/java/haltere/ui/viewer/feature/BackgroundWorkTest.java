package haltere.ui.viewer.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tasks when the window is closed; the process ends after that. */
class BackgroundWorkTest {
  @Test
  @Timeout(30)
  void closeWaitsUntilFilesAreWritten() throws InterruptedException {
    BackgroundWork background = new BackgroundWork();
    CountDownLatch slow = new CountDownLatch(1);
    AtomicBoolean written = new AtomicBoolean();
    background.file(slow::await, () -> {}, problem -> {});
    background.file(() -> written.set(true), () -> {}, problem -> {});
    Thread closing = new Thread(background::close);
    closing.start();
    while (closing.isAlive() && closing.getState() != Thread.State.TIMED_WAITING) {
      Thread.onSpinWait();
    }
    assertEquals(Thread.State.TIMED_WAITING, closing.getState());
    slow.countDown();
    closing.join();
    assertTrue(written.get());
  }
}
