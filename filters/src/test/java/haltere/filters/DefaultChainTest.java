package haltere.filters;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.fly.FlyScene;
import haltere.core.simulation.fly.FlySceneSettings;
import haltere.filters.cluster.ClusterSnapshot;
import haltere.filters.cluster.ClusterTrack;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.io.IOException;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class DefaultChainTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return DefaultChain.create(geometry);
  }

  @Override
  protected Object withoutIdentity(Object result) {
    if (result instanceof ClusterTrack track) {
      return List.of(track.timeUs(), track.xPx(), track.yPx(), track.events());
    }
    return ((ClusterSnapshot) result).clusters().size();
  }

  @Test
  void itRemovesNoiseAndThenFollowsWhatMoves() {
    FilterChain chain = DefaultChain.create(SENSOR);
    assertEquals(
        List.of("background-activity", "hot-pixels", "cluster-tracker"),
        chain.stages().stream().map(ChainStage::name).toList());
    BlobPath path = new BlobPath(64, 64, 35, 1e6, 6);
    EventPacket packet = EventPackets.blob(SENSOR, 1, 1_000_000, path, 50_000, 5);
    int before = packet.size();
    chain.process(packet);
    assertTrue(packet.size() < before - 50_000, "noise left: " + packet.size());
    assertTrue(packet.size() > 45_000, "events of the blob lost: " + packet.size());
  }

  @Test
  void theOneForAFlyTracksItsWings() throws IOException {
    FilterChain chain = DefaultChain.forFly(SENSOR);
    assertEquals(
        List.of("background-activity", "hot-pixels", "wing-tracker"),
        chain.stages().stream().map(ChainStage::name).toList());
    Set<WingPart> parts = EnumSet.noneOf(WingPart.class);
    chain.outlet("wings", WingEstimate.class).subscribe(row -> parts.add(row.edge()));
    FlyScene scene = new FlyScene(FlySceneSettings.defaults().with("run.durationS=0.1"));
    scene.drainTo(chain);
    assertEquals(EnumSet.of(WingPart.LEFT, WingPart.RIGHT), parts);
  }

  @Test
  void aChainFileHoldsAllOfIt() throws IOException {
    String text = ChainFile.write(DefaultChain.create(SENSOR));
    assertEquals(text, ChainFile.write(ChainFile.parse(text, "default", SENSOR)));
  }
}
