package haltere.filters.trail.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.overlay.MarkStyle.Role;
import haltere.filters.trail.Ellipse;
import haltere.filters.trail.TrailPoint;
import haltere.testing.OverlayNotes;
import java.util.List;
import org.junit.jupiter.api.Test;

class TrailOverlayTest {
  private static final Row BEFORE = new Row(0, 7, 10, 20, 0, 0);
  private static final Row NOW = new Row(10_000, 7, 11, 21, 100, -50);

  private record Row(long timeUs, int id, double xPx, double yPx, double vxPxS, double vyPxS)
      implements TrailPoint {}

  private static TrailMark mark(double angleRad, boolean isBox) {
    return new TrailMark(Role.OBJECT, new Ellipse(9, 4, angleRad), isBox, "seven", 3);
  }

  private static List<String> drawn(TrailMark mark) {
    Trails trails = new Trails();
    trails.add(BEFORE, mark, 2);
    trails.add(NOW, mark, 2);
    OverlayNotes notes = new OverlayNotes();
    new TrailOverlay().draw(trails.at(10_000), notes);
    return notes.marks();
  }

  @Test
  void objectIsDrawnAsPathEllipseVelocityAndLabel() {
    assertEquals(
        List.of(
            "PATH 7: [10.0, 11.0] [20.0, 21.0]",
            "OBJECT 7: ellipse 11.0 21.0 half axes 9.00 4.00 at 0.50",
            "VELOCITY 7: line 11.0 21.0 to 21.0 16.0",
            "LABEL 7: seven at 14.0 24.0"),
        drawn(mark(0.5, false)));
  }

  @Test
  void boxIsDrawnAsItsFourSides() {
    assertEquals(
        "OBJECT 7: [20.0, 2.0, 2.0, 20.0, 20.0] [25.0, 25.0, 17.0, 17.0, 25.0]",
        drawn(mark(0, true)).get(1));
  }

  @Test
  void objectIsExtrapolatedAndItsPathStays() {
    Trails trails = new Trails();
    trails.add(NOW, mark(0, false), 1);
    OverlayNotes notes = new OverlayNotes();
    new TrailOverlay().drawAt(trails.at(10_000), 60_000, notes);
    assertEquals("PATH 7: [11.0] [21.0]", notes.marks().get(0));
    assertEquals("OBJECT 7: ellipse 16.0 18.5 half axes 9.00 4.00 at 0.00", notes.marks().get(1));
  }

  @Test
  void pathHasTheLatestRowsAndEndsAtTheObject() {
    Trails trails = new Trails();
    trails.add(BEFORE, mark(0, false), 1);
    trails.add(NOW, mark(0, false), 1);
    assertEquals(List.of(NOW), trails.at(10_000).trails().get(0).path());
    assertEquals(NOW, trails.at(10_000).trails().get(0).now());
    assertEquals(List.of(), trails.at(20_000).trails());
    trails.add(NOW, mark(0, false), 1);
    trails.clear();
    assertEquals(List.of(), trails.at(10_000).trails());
  }

  @Test
  void emptySnapshotDrawsNothing() {
    OverlayNotes notes = new OverlayNotes();
    new TrailOverlay().draw(new TrailSnapshot(0, List.of()), notes);
    assertEquals(List.of(), notes.marks());
    TrailMark mark = mark(0, false);
    assertThrows(IllegalArgumentException.class, () -> new TrailSnapshot.Trail(List.of(), mark));
  }

  @Test
  void ellipseOfACovarianceLiesAlongTheLargerUncertainty() {
    Ellipse diagonal = Ellipse.of(1, -1, 1).times(2);
    assertEquals(2 * Math.sqrt(2), diagonal.majorPx(), 1e-12);
    assertEquals(0, diagonal.minorPx(), 1e-6);
    assertEquals(0.75 * Math.PI, diagonal.angleRad(), 1e-12);
    assertEquals(new Ellipse(3, 2, 0), Ellipse.of(9, 0, 4));
    assertEquals(Math.PI / 2, Ellipse.of(4, 0, 9).angleRad(), 1e-12);
  }
}
