package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

/** The share of events that the filters hide is that of what is shown. */
class PassedEventsTest {
  private final PassedEvents passed = new PassedEvents();

  private void slice(long before, long after) {
    passed.before += before;
    passed.after += after;
    passed.endSlice();
  }

  @Test
  void playbackShareNeedsManyEvents() {
    slice(100, 20);
    assertEquals(OptionalInt.empty(), passed.takePercentHidden());
    slice(100, 30);
    assertEquals(OptionalInt.of(75), passed.takePercentHidden());
  }

  @Test
  void heldSliceHasItsOwnShareEvenWithoutEvents() {
    slice(1000, 500);
    slice(4, 1);
    passed.hold();
    assertEquals(OptionalInt.of(75), passed.takePercentHidden());
    slice(0, 0);
    passed.hold();
    assertEquals(OptionalInt.of(0), passed.takePercentHidden());
  }
}
