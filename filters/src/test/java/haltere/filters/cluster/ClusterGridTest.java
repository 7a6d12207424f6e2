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
      Cluster[] clusters = clusters(random, random.nextInt(1, 30));
      ClusterGrid grid = new ClusterGrid(SENSOR);
      grid.index(clusters, clusters.length, UPKEEP_US * 1e-6);
      long timeUs = random.nextInt(UPKEEP_US);
      for (int y = 0; y < SENSOR.height(); y++) {
        for (int x = 0; x < SENSOR.width(); x++) {
          List<Integer> all = new ArrayList<>();
          for (int i = 0; i < clusters.length; i++) {
            if (clusters[i].distance(x, y, timeUs, false) < 1) {
              all.add(i);
            }
          }
          assertTrue(named(grid, x, y, clusters.length).containsAll(all), x + ", " + y);
        }
      }
    }
  }

  @Test
  void farFromAllClustersTheGridNamesNone() {
    Cluster[] clusters = clusters(new SplittableRandom(2), 1);
    clusters[0].x = 20;
    clusters[0].y = 20;
    ClusterGrid grid = new ClusterGrid(SENSOR);
    grid.index(clusters, 1, UPKEEP_US * 1e-6);
    assertEquals(List.of(), named(grid, 150, 100, 1));
    grid.index(clusters, 0, UPKEEP_US * 1e-6);
    assertEquals(List.of(), named(grid, 20, 20, 1));
  }

  private static List<Integer> named(ClusterGrid grid, int x, int y, int clusters) {
    List<Integer> named = new ArrayList<>();
    int cell = grid.cellOf(x, y);
    boolean all = grid.count(cell) == ClusterGrid.ALL;
    for (int i = 0; i < (all ? clusters : grid.count(cell)); i++) {
      named.add(all ? i : grid.name(cell, i));
    }
    return named;
  }

  private static Cluster[] clusters(SplittableRandom random, int count) {
    ClusterForm form = new ClusterForm(SENSOR, ClusterTrackerSettings.defaults());
    Cluster[] clusters = new Cluster[count];
    for (int i = 0; i < count; i++) {
      Cluster cluster = new Cluster(i);
      cluster.x = random.nextDouble(SENSOR.width());
      cluster.y = random.nextDouble(SENSOR.height());
      cluster.vx = random.nextDouble(-5000, 5000);
      cluster.vy = random.nextDouble(-5000, 5000);
      cluster.carry = 1e-6;
      form.begin(cluster);
      cluster.cxx *= random.nextDouble(0.1, 3);
      cluster.cyy *= random.nextDouble(0.1, 3);
      form.settle(cluster, 0);
      clusters[i] = cluster;
    }
    return clusters;
  }
}
