package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ClusterMergingTest {
  private static final int UPKEEP_US = 1000;

  private final Cluster first = cluster(0);
  private final Cluster second = cluster(1);
  private ClusterMerging merging = merging();
  private long timeUs;

  private static ClusterMerging merging(String... changes) {
    ClusterMerging made = new ClusterMerging();
    made.apply(ClusterTrackerSettings.defaults().with(changes).merging(), 2);
    return made;
  }

  private static Cluster cluster(int slot) {
    Cluster cluster = new Cluster(slot);
    cluster.id = slot + 1;
    cluster.x = 50;
    cluster.y = 50;
    cluster.cos = 1;
    cluster.setRadii(5, 5);
    cluster.extentX = 6.5;
    cluster.extentY = 6.5;
    cluster.mass = 100;
    return cluster;
  }

  /**
   * Milliseconds until the two become one as they are, or -1 if they do not within three seconds.
   */
  private int untilOne() {
    for (int i = 1; i <= 3000; i++) {
      timeUs += UPKEEP_US;
      if (merging.unite(first, second, timeUs, UPKEEP_US)) {
        return i;
      }
    }
    return -1;
  }

  private void seeApart() {
    second.x = 80;
    assertEquals(-1, untilOne());
    second.x = 53;
  }

  @Test
  void twoThatWereNeverSeenApartAreSoonOne() {
    second.x = 53;
    assertEquals(20, untilOne());
  }

  @Test
  void twoThatWereSeenApartAreOneAfterALongTime() {
    seeApart();
    assertEquals(1000, untilOne());
  }

  @Test
  void twoThatMeetAtAnAngleStayTwoIfTheAngleIsADifferentOne() {
    merging = merging("merging.differentAngleDeg=60");
    seeApart();
    first.vx = 8;
    second.vy = 8;
    assertEquals(-1, untilOne());
    merging = merging("merging.differentAngleDeg=120");
    seeApart();
    assertEquals(1000, untilOne());
  }

  @Test
  void twoThatSoonPartAreNotOneWhateverTheirDirection() {
    seeApart();
    first.vx = 30;
    second.vx = 70;
    assertEquals(-1, untilOne());
  }

  @Test
  void velocitiesThatAreNotKnownAreNotDifferent() {
    seeApart();
    first.vx = 30;
    second.vx = 70;
    second.velocityVariance = 40 * 40;
    assertEquals(1000, untilOne());
  }

  @Test
  void twoThatAreKeptApartMergeWhenThatIsOver() {
    second.x = 53;
    merging.keepApart(first, second, 100_000);
    assertEquals(120, untilOne());
  }

  @Test
  void theEdgesInFrontAndBehindMergeAllTheSame() {
    second.x = 65;
    first.balance = 0.9;
    second.balance = -0.9;
    merging.keepApart(first, second, Long.MAX_VALUE);
    assertEquals(20, untilOne());
    second.balance = 0.9;
    merging.reset();
    assertEquals(-1, untilOne());
  }

  @Test
  void nothingMergesIfItIsNotAllowed() {
    merging = merging("merging.allowed=false");
    second.x = 51;
    assertEquals(-1, untilOne());
    assertTrue(first.overlapped && second.overlapped);
  }

  @Test
  void theOneThatStaysTakesTheSizeOfBothIfItIsToldTo() {
    second.x = 56;
    first.cxx = 4;
    second.cxx = 4;
    merging.absorb(first, second);
    assertEquals(53, first.x, 1e-9);
    assertEquals(4 + 9, first.cxx, 1e-9);
    merging = merging("merging.joinSize=false");
    first.cxx = 4;
    merging.absorb(first, second);
    assertEquals(4, first.cxx, 1e-9);
  }

  @Test
  void theVisibleOneStaysElseTheHeavierOne() {
    second.mass = 200;
    assertFalse(merging.isStronger(first, second));
    second.id = 0;
    assertTrue(merging.isStronger(first, second));
  }

  @Test
  void twoThatHavePartedAndStayInOnePlaceAreSoonOneAgain() {
    merging.parted(first, second);
    second.x = 53;
    assertEquals(200, untilOne());
  }

  @Test
  void twoThatHavePartedAndAreSeenApartAreTwo() {
    merging.parted(first, second);
    seeApart();
    assertEquals(1000, untilOne());
  }

  @Test
  void twoThatHavePartedAndAreBesideEachOtherAreTwo() {
    merging.parted(first, second);
    second.x = 55;
    assertEquals(1000, untilOne());
  }

  @Test
  void ofTwoThatHavePartedTheOneWhoseIdentityItWasStays() {
    second.mass = 200;
    merging.parted(first, second);
    assertTrue(merging.isStronger(first, second));
    assertFalse(merging.isStronger(second, first));
  }
}
