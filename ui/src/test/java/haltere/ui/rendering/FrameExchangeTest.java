package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;

class FrameExchangeTest {
  private final FrameExchange<long[]> exchange = new FrameExchange<>(() -> new long[2]);

  @Test
  void eachPictureIsFetchedOnce() {
    assertNull(exchange.fetch());
    assertFalse(exchange.isPending());
    long[] painted = exchange.back();
    exchange.publish();
    assertTrue(exchange.isPending());
    assertSame(painted, exchange.fetch());
    assertNull(exchange.fetch());
  }

  @Test
  void newerPictureReplacesAnUnfetchedOneAndIsCounted() {
    long[] first = exchange.back();
    exchange.publish();
    long[] second = exchange.back();
    assertNotSame(first, second);
    exchange.publish();
    assertSame(second, exchange.fetch());
    assertEquals(1, exchange.conflated());
  }

  @Test
  void displayedPictureIsNeverModified() throws InterruptedException {
    AtomicBoolean stop = new AtomicBoolean();
    Thread painter =
        new Thread(
            () -> {
              for (long number = 1; !stop.get(); number++) {
                long[] picture = exchange.back();
                picture[0] = number;
                picture[1] = number;
                exchange.publish();
              }
            });
    painter.start();
    long last = 0;
    for (int fetched = 0; fetched < 20_000; ) {
      long[] picture = exchange.fetch();
      if (picture != null) {
        long first = picture[0];
        Thread.onSpinWait();
        assertEquals(first, picture[1]);
        assertTrue(first > last, "pictures come in order");
        last = first;
        fetched++;
      }
    }
    stop.set(true);
    painter.join();
  }
}
