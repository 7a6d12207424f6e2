package haltere.ui.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.testing.Allocation;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** From the processing thread to the window, without waiting. */
class SampleQueueTest {
  @Test
  void samplesBeyondTheCapacityAreCounted() {
    SampleQueue queue = new SampleQueue(8);
    for (int i = 0; i < 20; i++) {
      queue.put(i, "a", i);
    }
    AtomicLong taken = new AtomicLong();
    queue.drainTo((timeUs, key, value) -> taken.incrementAndGet());
    assertEquals(8, taken.get());
    assertEquals(12, queue.lost());
  }

  @Test
  void addingASampleAllocatesNoMemory() {
    SampleQueue queue = new SampleQueue(100);
    SampleQueue.SampleConsumer nobody = (timeUs, key, value) -> {};
    Runnable run =
        () -> {
          for (int i = 0; i < 100; i++) {
            queue.put(i, "a", i);
          }
          queue.drainTo(nobody);
        };
    assertEquals(0, Allocation.bytesOf(run, 0));
    assertEquals(0, queue.lost());
  }

  @Test
  void orderAndCountsArePreservedBetweenTwoThreads() throws InterruptedException {
    SampleQueue queue = new SampleQueue(64);
    int samples = 200_000;
    Thread writer =
        new Thread(
            () -> {
              for (int i = 0; i < samples; i++) {
                queue.put(i, "a", 2.0 * i);
              }
            });
    writer.start();
    long[] lastAndCount = {-1, 0};
    SampleQueue.SampleConsumer consumer =
        (timeUs, key, value) -> {
          assertEquals(2.0 * timeUs, value);
          assertEquals(true, timeUs > lastAndCount[0]);
          lastAndCount[0] = timeUs;
          lastAndCount[1]++;
        };
    while (writer.isAlive()) {
      queue.drainTo(consumer);
    }
    writer.join();
    queue.drainTo(consumer);
    assertEquals(samples, lastAndCount[1] + queue.lost());
  }
}
