package haltere.filters.cluster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.filters.cluster.ClusterShapeSettings.Type;
import haltere.testing.OverlayNotes;
import java.util.List;
import org.junit.jupiter.api.Test;

class ClusterTrackOverlayTest {
  private static final ClusterTrack BEFORE =
      new ClusterTrack(0, 7, 10, 20, 0, 0, 5, 1, 0, 100, 20, 1000, 0);

  private static ClusterTrack now(double angleRad) {
    return new ClusterTrack(10_000, 7, 11, 21, 100, -50, 6, 2.25, angleRad, 200, 20, 1000, 10_000);
  }

  private static List<String> drawn(Type type, double angleRad) {
    OverlayNotes notes = new OverlayNotes();
    ClusterSnapshot.Trail trail = new ClusterSnapshot.Trail(List.of(BEFORE, now(angleRad)));
    new ClusterTrackOverlay().draw(new ClusterSnapshot(10_000, type, List.of(trail)), notes);
    return notes.marks();
  }

  @Test
  void aClusterIsAnEllipseWithItsPathItsVelocityAndItsIdentity() {
    assertEquals(
        List.of(
            "PATH 7: [10.0, 11.0] [20.0, 21.0]",
            "OBJECT 7: ellipse 11.0 21.0 half axes 9.00 4.00 at 0.50",
            "VELOCITY 7: line 11.0 21.0 to 21.0 16.0",
            "LABEL 7: 7 at 15.2 25.2"),
        drawn(Type.ELLIPSE, 0.5));
  }

  @Test
  void aBoxIsDrawnAsItsFourSides() {
    assertEquals(
        "OBJECT 7: [20.0, 2.0, 2.0, 20.0, 20.0] [25.0, 25.0, 17.0, 17.0, 25.0]",
        drawn(Type.BOX, 0).get(1));
  }

  @Test
  void nothingIsDrawnOfNoCluster() {
    OverlayNotes notes = new OverlayNotes();
    new ClusterTrackOverlay().draw(new ClusterSnapshot(0, Type.BOX, List.of()), notes);
    assertEquals(List.of(), notes.marks());
    assertThrows(IllegalArgumentException.class, () -> new ClusterSnapshot.Trail(List.of()));
  }
}
