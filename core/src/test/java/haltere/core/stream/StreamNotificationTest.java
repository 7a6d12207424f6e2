package haltere.core.stream;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class StreamNotificationTest {
  @Test
  void timeGoesOnAfterLostDataAndStartsAnewAfterAReset() {
    DataLost lost = new DataLost(-1, 3, 10, 20, "USB");
    assertTrue(lost.endsContinuity());
    assertFalse(lost.restartsTime());
    for (Reset.Cause cause : Reset.Cause.values()) {
      assertTrue(new Reset(cause).restartsTime(), cause.toString());
    }
  }
}
