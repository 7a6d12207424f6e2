package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ClusterGridTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(200, 120);
  private static final int UPKEEP_US = 1000;

  @Test
  void atEachPixelTheGridNamesAllClustersThatALookAtEveryOneFinds() {
    SplittableRandom random = new SplittableRandom(1);
    for (int round = 0; round < 30; round++) {
      Clusters clusters = clusters(random, random.nextInt(1, 30));
      ClusterGrid grid = new ClusterGrid(SENSOR);
      grid.index(clusters, UPKEEP_US * 1e-6);
      assertNamesAll(grid, clusters, random.nextInt(UPKEEP_US));
    }
  }

  @Test
  void clustersThatMoveAndGrowAndChangeTheirVelocityAreFoundAfterEachRefreshing() {
    SplittableRandom random = new SplittableRandom(3);
    for (int round = 0; round < 10; round++) {
      Clusters clusters = clusters(random, 12);
      ClusterGrid grid = new ClusterGrid(SENSOR);
      grid.index(clusters, UPKEEP_US * 1e-6);
      for (int upkeep = 1; upkeep <= 20; upkeep++) {
        for (int i = 0; i < clusters.count; i++) {
          Cluster cluster = clusters.all[i];
          cluster.moveTo((long) upkeep * UPKEEP_US);
          cluster.vx += random.nextDouble(-500, 500);
          double wider = random.nextDouble(0.97, 1.03);
          cluster.m11 /= wider;
          cluster.m12 /= wider;
          cluster.m21 /= wider;
          cluster.m22 /= wider;
          cluster.extentX *= wider;
          cluster.extentY *= wider;
        }
        if (upkeep % 7 == 0) {
          clusters.remove(random.nextInt(clusters.count));
        }
        grid.refresh(clusters, UPKEEP_US * 1e-6);
        assertNamesAll(grid, clusters, (long) upkeep * UPKEEP_US + random.nextInt(UPKEEP_US));
      }
    }
  }

  @Test
  void clustersThatHaveHardlyMovedKeepTheirCells() {
    Clusters clusters = clusters(new SplittableRandom(4), 1);
    Cluster cluster = clusters.all[0];
    cluster.vx = 0;
    cluster.vy = 0;
    ClusterGrid grid = new ClusterGrid(SENSOR);
    grid.index(clusters, UPKEEP_US * 1e-6);
    double x = cluster.indexX;
    cluster.x += 1.5;
    grid.refresh(clusters, UPKEEP_US * 1e-6);
    assertEquals(x, cluster.indexX, "the cells are those of before");
    cluster.x += 1;
    grid.refresh(clusters, UPKEEP_US * 1e-6);
    assertEquals(cluster.x, cluster.indexX, "it has got new cells");
  }

  private static void assertNamesAll(ClusterGrid grid, Clusters clusters, long timeUs) {
    for (int y = 0; y < SENSOR.height(); y++) {
      for (int x = 0; x < SENSOR.width(); x++) {
        List<Integer> all = new ArrayList<>();
        for (int i = 0; i < clusters.count; i++) {
          if (clusters.all[i].distance(x, y, timeUs, false) < 1) {
            all.add(i);
          }
        }
        assertTrue(named(grid, x, y, clusters.count).containsAll(all), x + ", " + y);
      }
    }
  }

  @Test
  void farFromAllClustersTheGridNamesNone() {
    Clusters clusters = clusters(new SplittableRandom(2), 1);
    clusters.all[0].x = 20;
    clusters.all[0].y = 20;
    ClusterGrid grid = new ClusterGrid(SENSOR);
    grid.index(clusters, UPKEEP_US * 1e-6);
    assertEquals(List.of(), named(grid, 150, 100, 1));
    clusters.count = 0;
    grid.index(clusters, UPKEEP_US * 1e-6);
    assertEquals(List.of(), named(grid, 20, 20, 1));
  }

  private static List<Integer> named(ClusterGrid grid, int x, int y, int clusters) {
    List<Integer> named = new ArrayList<>();
    int cell = grid.at(x, y);
    boolean all = cell == ClusterGrid.ALL;
    for (int i = 0; i < (all ? clusters : ClusterGrid.count(cell)); i++) {
      named.add(all ? i : ClusterGrid.name(cell, i));
    }
    return named;
  }

  private static Clusters clusters(SplittableRandom random, int count) {
    ClusterForm form = new ClusterForm(SENSOR, ClusterTrackerSettings.defaults());
    Clusters clusters = new Clusters();
    clusters.setMost(count);
    for (int i = 0; i < count; i++) {
      Cluster cluster = clusters.add();
      cluster.x = random.nextDouble(SENSOR.width());
      cluster.y = random.nextDouble(SENSOR.height());
      cluster.vx = random.nextDouble(-5000, 5000);
      cluster.vy = random.nextDouble(-5000, 5000);
      cluster.carry = 1e-6;
      form.begin(cluster);
      cluster.cxx *= random.nextDouble(0.1, 3);
      cluster.cyy *= random.nextDouble(0.1, 3);
      form.settle(cluster, 0);
    }
    return clusters;
  }
}
