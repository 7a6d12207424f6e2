package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.filters.plane.PlanePoint;
import haltere.testing.OverlayNotes;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class TrackOverlayTest {
  private static final TrackPoint BEFORE = new TrackPoint(0, 7, 10, 20, 0, 0, 1, 1, 1, 1, 5);
  private static final TrackPoint NOW = new TrackPoint(10_000, 7, 11, 21, 100, -50, 2, 1, 1, 1, 9);

  private static List<String> drawn(TrackSnapshot.Shown track) {
    OverlayNotes notes = new OverlayNotes();
    new TrackOverlay().draw(new TrackSnapshot(10_000, List.of(track)), notes);
    return notes.marks();
  }

  @Test
  void aTrackIsItsPathItsEllipseItsVelocityAndItsIdentity() {
    assertEquals(
        List.of(
            "PATH 7: [10.0, 11.0] [20.0, 21.0]",
            "UNCERTAINTY 7: ellipse 11.0 21.0 half axes 4.90 2.45 at 0.00",
            "VELOCITY 7: line 11.0 21.0 to 21.0 16.0",
            "LABEL 7: 7 at 14.0 24.0"),
        drawn(new TrackSnapshot.Shown(List.of(BEFORE, NOW), 0, false, Optional.empty())));
  }

  @Test
  void onARoadTheSpeedIsWrittenAndACoastingTrackStandsOut() {
    PlanePoint onRoad = new PlanePoint(10_000, 7, 0, 40, 3, -14.6, 1, 1, 1, 1);
    List<String> marks = drawn(new TrackSnapshot.Shown(List.of(NOW), 0, true, Optional.of(onRoad)));
    assertEquals("WARNING 7: ellipse 11.0 21.0 half axes 4.90 2.45 at 0.00", marks.get(1));
    assertEquals("LABEL 7: 7: 54 km/h at 14.0 24.0", marks.get(3));
  }

  @Test
  void theEllipseLiesAlongTheLargerUncertainty() {
    TrackPoint diagonal = new TrackPoint(0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1);
    List<String> marks =
        drawn(new TrackSnapshot.Shown(List.of(diagonal), -1, false, Optional.empty()));
    assertEquals("UNCERTAINTY 1: ellipse 0.0 0.0 half axes 3.46 0.00 at -0.79", marks.get(1));
  }
}
