package haltere.filters;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.filters.object.ObjectTrack;
import haltere.filters.trail.internal.TrailSnapshot;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.io.IOException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class DefaultChainTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return DefaultChain.create(geometry);
  }

  @Override
  protected Object withoutIdentity(Object result) {
    if (result instanceof ObjectTrack track) {
      return List.of(track.timeUs(), track.xPx(), track.yPx(), track.vxPxS(), track.events());
    }
    return ((TrailSnapshot) result)
        .trails().stream()
            .map(trail -> trail.path().stream().map(this::withoutIdentity).toList())
            .collect(Collectors.toSet());
  }

  @Test
  void movingObjectsAreTrackedWithoutANoiseFilter() {
    FilterChain chain = DefaultChain.create(SENSOR);
    assertEquals(List.of("object-tracker"), chain.stages().stream().map(ChainStage::name).toList());
    List<ObjectTrack> rows = new ArrayList<>();
    chain.outlet("objects", ObjectTrack.class).subscribe(rows::add);
    BlobPath path = new BlobPath(64, 64, 35, 1e6, 6);
    EventPacket packet = EventPackets.blob(SENSOR, 1, 1_000_000, path, 50_000, 5);
    int before = packet.size();
    chain.process(packet);
    assertEquals(before, packet.size(), "it lets all events through");
    assertEquals(1, rows.stream().mapToInt(ObjectTrack::id).distinct().count(), "identities");
    assertTrue(rows.size() > 80, rows.size() + " rows");
    for (ObjectTrack row : rows.subList(20, rows.size())) {
      double x = path.x(row.timeUs());
      double y = path.y(row.timeUs());
      assertEquals(0, Math.hypot(row.xPx() - x, row.yPx() - y), 4, row.toString());
    }
  }

  @Test
  void flyChainTracksWings() throws IOException {
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
  void defaultChainIsSavedAndReadBack() throws IOException {
    String text = ChainFile.write(DefaultChain.create(SENSOR));
    assertEquals(text, ChainFile.write(ChainFile.parse(text, "default", SENSOR)));
  }
}
