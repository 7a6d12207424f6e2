package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A cluster at x = 100 with its events at two places, 8 pixels to the left and to the right. */
class ClusterPartingTest {
  private static final long TIME_US = 500_000;
  private static final double APART_PX = 8;

  private final Clusters clusters = new Clusters();
  private final ClusterMerging merging = new ClusterMerging();
  private final ClusterParting parting = new ClusterParting(clusters, merging);
  private ClusterForm form;
  private Cluster whole;

  @BeforeEach
  void makeOneOfTwo() {
    SensorGeometry geometry = new SensorGeometry(240, 180);
    ClusterTrackerSettings settings = ClusterTrackerSettings.defaults();
    form = new ClusterForm(geometry, settings);
    BirthPlaces places = new BirthPlaces(geometry, form.startRadius());
    places.apply(settings);
    clusters.setMost(4);
    merging.apply(settings.merging(), 4);
    parting.apply(new ClusterMotion(settings), form, new ClusterLife(geometry, settings, places));
    whole = cluster(1, 100);
    whole.cxx = APART_PX * APART_PX + 4;
    whole.cyy = 4;
    whole.square = whole.cxx;
    whole.usualMass = 100;
    form.upkeep(whole, TIME_US, 0);
  }

  private Cluster cluster(int id, double x) {
    Cluster made = clusters.add();
    made.id = id;
    made.x = x;
    made.y = 90;
    made.mass = 100;
    made.rateHz = 3000;
    form.begin(made);
    return made;
  }

  @Test
  void aClusterAtTwoPlacesBecomesTwo() {
    parting.part(whole, TIME_US);
    assertEquals(2, clusters.count);
    assertEquals(100, 0.5 * (clusters.all[0].x + clusters.all[1].x), 1e-9);
    assertTrue(Math.abs(clusters.all[0].x - clusters.all[1].x) > APART_PX);
  }

  @Test
  void itStaysWhereMoreOfItsEventsAre() {
    for (int side = -1; side <= 1; side += 2) {
      clusters.count = 0;
      makeOneOfTwo();
      whole.cube = side * Math.pow(whole.square, 1.5);
      parting.part(whole, TIME_US);
      Cluster born = clusters.all[1];
      assertTrue(born.mass < 30, born.mass + " of 100 events");
      assertEquals(100, whole.mass + born.mass, 1e-9);
      assertTrue(side * (born.x - whole.x) * whole.cos > 0);
      assertTrue(Math.abs(whole.x - 100) < Math.abs(born.x - 100));
    }
  }

  @Test
  void whereOnePlaceIsAnotherClustersItGoesToTheOtherPlaceAndNothingIsBorn() {
    for (int side = -1; side <= 1; side += 2) {
      clusters.count = 0;
      makeOneOfTwo();
      Cluster neighbour = cluster(2, 100 + side * APART_PX);
      parting.part(whole, TIME_US);
      assertEquals(2, clusters.count);
      assertSame(neighbour, clusters.all[1]);
      assertEquals(1, whole.id);
      assertEquals(100 - side * APART_PX, whole.x, 1.5);
      assertEquals(50, whole.mass, 1e-9);
    }
  }

  @Test
  void aClusterThatIsNotSeenYetHasNoPlaceOfItsOwn() {
    cluster(0, 100 + APART_PX);
    parting.part(whole, TIME_US);
    assertEquals(3, clusters.count);
  }
}
