package haltere.core.playback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

class LoopTest {
  @Test
  void loopPointsAreOptional() {
    Loop toTheEnd = new Loop(true, OptionalLong.of(1_000_000), OptionalLong.empty());
    assertEquals(1_000_000, toTheEnd.inUs().getAsLong());
    Loop fromTheStart = new Loop(true, OptionalLong.empty(), OptionalLong.of(1));
    assertEquals(1, fromTheStart.outUs().getAsLong());
  }

  @Test
  void emptyLoopIsRejected() {
    assertThrows(IllegalArgumentException.class, () -> Loop.between(5, 5));
    assertThrows(IllegalArgumentException.class, () -> Loop.between(-1, 5));
    assertThrows(
        IllegalArgumentException.class,
        () -> new Loop(true, OptionalLong.empty(), OptionalLong.of(0)));
  }
}
