package haltere.core.format.internal.reader;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.internal.decoding.SampleCursor;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class SampleOrderTest {
  private static final long FAR = 1L << 30;

  /** A file of two gigabytes whose only sample is in its middle. */
  private static final class LonelyTrigger implements SampleCursor {
    private final Trigger trigger =
        new Trigger(5_000, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 0);
    private long looked;
    private boolean given;

    @Override
    public SampleStep next(long untilOffset) {
      looked = Math.max(looked, Math.min(untilOffset, 2 * FAR));
      if (!given && looked >= FAR) {
        given = true;
        return SampleStep.SAMPLE;
      }
      return looked == 2 * FAR ? SampleStep.END : SampleStep.NOTHING_YET;
    }

    @Override
    public SensorSample sample() {
      return trigger;
    }

    @Override
    public long offset() {
      return FAR;
    }

    @Override
    public void restore(long[] state, int at) {
      throw new UnsupportedOperationException();
    }

    @Override
    public void close() {}
  }

  @Test
  void distantSamplesAreReadOnlyNearTheEvents() throws IOException {
    LonelyTrigger file = new LonelyTrigger();
    try (SampleOrder order = new SampleOrder(file)) {
      for (long offset = 0; offset < FAR - (16 << 20); offset += 1 << 20) {
        assertFalse(order.isDueBefore(1_000, offset));
        assertTrue(file.looked <= offset + (16 << 20), "looked up to " + file.looked);
      }
    }
  }

  @Test
  void sampleIsDeliveredAtItsTimeAmongEvents() throws IOException {
    try (SampleOrder order = new SampleOrder(new LonelyTrigger())) {
      assertFalse(order.isDueBefore(4_999, FAR - (16 << 20)));
      assertTrue(order.isDueBefore(5_000, FAR - (16 << 20)));
      assertEquals(5_000, order.take().timeUs());
      assertFalse(order.isDueBeforeEnd());
    }
  }

  @Test
  void sampleAfterAllEventsIsDeliveredBeforeTheEnd() throws IOException {
    try (SampleOrder order = new SampleOrder(new LonelyTrigger())) {
      assertTrue(order.isDueBeforeEnd());
      assertFalse(order.isDueBeforeRestart(FAR - 1));
      assertTrue(order.isDueBeforeRestart(FAR));
    }
  }
}
