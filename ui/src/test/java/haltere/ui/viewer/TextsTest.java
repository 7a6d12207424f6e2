package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import org.junit.jupiter.api.Test;

class TextsTest {
  private static PlayerStatus late(String slowestStage, double sourceShare) {
    return new PlayerStatus(
        State.PLAYING, 0, 0, -1, 1, 0.5, 1_200_000, slowestStage, sourceShare, 0, 0, 0, 0, 1, "");
  }

  @Test
  void whatIsLateIsNamedAfterWhatTakesTheTime() {
    String behind = Texts.duration(1_200_000) + " behind";
    assertEquals("The chain is " + behind + ": dawdler", Texts.late(late("dawdler", 0.2)));
    assertEquals("The chain is " + behind, Texts.late(late("", 0)));
    String source = Texts.late(late("dawdler", 0.8));
    assertTrue(source.startsWith("The source is " + behind), source);
    assertTrue(!source.contains("dawdler"), source);
  }
}
