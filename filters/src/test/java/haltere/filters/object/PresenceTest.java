package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class PresenceTest {
  private static final double[] SILENCE = new double[Presence.ATTENUATIONS.length];

  private final Presence presence = new Presence();

  PresenceTest() {
    presence.begin();
  }

  private static double[] events(double count, double ratio) {
    double[] logs = new double[Presence.ATTENUATIONS.length];
    for (int i = 0; i < logs.length; i++) {
      logs[i] = count * Math.log1p(ratio * Presence.ATTENUATIONS[i]);
    }
    return logs;
  }

  private void run(int ticks, double[] logs, double inside) {
    for (int i = 0; i < ticks; i++) {
      presence.update(logs, 10, inside);
    }
  }

  @Test
  void expectedEventsIndicateMotion() {
    run(5, events(10, 20), 1);
    assertTrue(presence.moving() > 0.98, presence.moving() + "");
  }

  @Test
  void oneFifthOfTheExpectedEventsStillIndicatesMotion() {
    run(50, events(2, 20), 1);
    assertTrue(presence.isMoving());
  }

  @Test
  void silenceInsideThePictureIndicatesRestFirstAndAnEndLater() {
    run(20, events(10, 20), 1);
    run(10, SILENCE, 1);
    assertFalse(presence.isMoving());
    assertTrue(presence.gone() < 0.3, presence.gone() + "");
    run(400, SILENCE, 1);
    assertTrue(presence.gone() > 0.5, presence.gone() + "");
  }

  @Test
  void silenceOutsideThePictureIndicatesAnEnd() {
    run(20, events(10, 20), 1);
    run(20, SILENCE, 0);
    assertTrue(presence.gone() > 0.5, presence.gone() + "");
  }

  @Test
  void restingObjectMovesAgainOnceItHasEvents() {
    run(20, events(10, 20), 1);
    run(50, SILENCE, 1);
    run(3, events(10, 20), 1);
    assertTrue(presence.isMoving());
  }

  @Test
  void probabilitiesStayValidForExtremeEvidence() {
    for (double log : new double[] {1e6, -1e6}) {
      presence.update(new double[] {log, log, log}, 1e6, 1);
      double rest = 1 - presence.moving() - presence.gone();
      assertTrue(rest >= -1e-12 && rest <= 1, rest + "");
      assertEquals(1, presence.moving() + presence.gone() + rest, 1e-12);
    }
  }
}
