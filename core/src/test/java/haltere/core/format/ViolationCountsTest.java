package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ViolationCountsTest {
  @Test
  void oneViolationAndSeveralAreWrittenAsOneWouldSayThem() {
    ViolationCounts counts = new ViolationCounts();
    counts.add(Violation.DAMAGED_PACKET, 700, 1);
    counts.add(Violation.OTHER_DATA, 9, 2000);
    assertEquals(
        List.of(
            "1 damaged packet was left out (first at byte 700)",
            "2,000 words hold data other than polarity events, which are not read (first at byte"
                + " 9)"),
        counts.describe());
  }
}
