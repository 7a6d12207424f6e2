package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PacketPoolTest {
  private final PacketPool pool = new PacketPool(3, 4);

  @Test
  void lastReleasedPacketIsReusedFirst() throws InterruptedException {
    EventPacket first = pool.take();
    EventPacket second = pool.take();
    second.append(5, 1, 1, true);
    pool.release(first);
    pool.release(second);
    assertSame(second, pool.take());
    assertTrue(second.isEmpty());
    assertSame(first, pool.poll());
  }

  @Test
  void takeWaitsForAFreePacket() throws InterruptedException {
    EventPacket last = pool.take();
    pool.take();
    pool.take();
    assertNull(pool.poll());
    Thread consumer = new Thread(() -> pool.release(last));
    consumer.start();
    assertSame(last, pool.take());
    consumer.join();
  }

  @Test
  void packetOfNoPoolIsRejected() {
    assertThrows(IllegalStateException.class, () -> pool.release(new EventPacket(1)));
  }
}
