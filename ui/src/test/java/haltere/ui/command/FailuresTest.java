package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterFailure;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.junit.jupiter.api.Test;

/** The one line for what went wrong. */
class FailuresTest {
  private static String said(RuntimeException thrown) {
    FilterChain chain = new FilterChain(new SensorGeometry(4, 4));
    chain.add(
        "tracker",
        new EventFilter() {
          @Override
          public void process(EventPacket packet) {
            throw thrown;
          }

          @Override
          public void reset() {}
        });
    EventPacket packet = new EventPacket(1);
    packet.append(1, 0, 0, true);
    return Failures.describe(assertThrows(FilterFailure.class, () -> chain.process(packet)));
  }

  @Test
  void unwritableTableIsNotReportedAsAFaultOfTheFilter() {
    String full = "t.csv: cannot be written: No space left on device";
    assertEquals(
        "results of filter tracker were lost: " + full,
        said(new UncheckedIOException(new IOException(full))));
  }

  @Test
  void overlongNameIsShortenedInItsMiddle() {
    String line = CommandRun.of("info", "a".repeat(5000)).err();
    assertTrue(line.length() < 300 && line.contains("aaa...aaa"), line);
  }

  @Test
  void faultOfAFilterIsReportedAsSuch() {
    String line = said(new IllegalStateException("odd"));
    assertTrue(
        line.contains("filter tracker failed") && line.contains("fault in the filter"), line);
  }
}
