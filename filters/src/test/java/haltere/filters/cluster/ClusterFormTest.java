package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import org.junit.jupiter.api.Test;

class ClusterFormTest {
  /** Where the first half axis goes along the velocity, its spread is not the greatest one. */
  @Test
  void thePartsOfALongClusterThatMovesAcrossItselfHaveCovariances() {
    ClusterForm form =
        new ClusterForm(
            new SensorGeometry(240, 180),
            ClusterTrackerSettings.defaults().with("form.angle=of-velocity"));
    Cluster cluster = new Cluster(0);
    cluster.x = 100;
    cluster.y = 90;
    form.begin(cluster);
    cluster.vx = 80;
    cluster.vy = 80;
    cluster.cxx = 12;
    cluster.cxy = -9;
    cluster.cyy = 8;
    form.upkeep(cluster, 200_000, 0);
    cluster.square = 6;
    Cluster born = new Cluster(1);
    form.part(cluster, born, 200_000);
    for (Cluster part : new Cluster[] {cluster, born}) {
      assertTrue(part.density > 0, "density " + part.density);
      assertTrue(part.likelihood(100, 90, 1, 200_000) > 0);
    }
  }
}
