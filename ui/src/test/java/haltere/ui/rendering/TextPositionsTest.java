package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class TextPositionsTest {
  private static final MarkStyle LABEL = MarkStyle.of(Role.LABEL, 7);
  private static final MarkStyle LINE = MarkStyle.of(Role.REGION);

  private final TextPositions positions = new TextPositions();

  @BeforeEach
  void begin() {
    positions.begin(400, 300);
  }

  private boolean find(double left, double base, MarkStyle style) {
    return positions.find(left, base, 100, 10, 4, 3, style);
  }

  @Test
  void laterLabelMovesAsideOfAnEarlierOne() {
    assertTrue(find(200, 150, LABEL));
    assertEquals(List.of(200.0, 150.0), List.of(positions.left(), positions.base()));
    assertTrue(find(210, 150, LABEL));
    assertEquals(List.of(210.0, 136.0), List.of(positions.left(), positions.base()), "above");
    assertTrue(find(205, 150, LABEL));
    assertEquals(List.of(205.0, 164.0), List.of(positions.left(), positions.base()), "below");
    assertTrue(find(205, 150, LABEL));
    assertEquals(List.of(93.0, 150.0), List.of(positions.left(), positions.base()), "to the left");
  }

  @Test
  void labelWithoutSpaceIsOmittedAndOtherTextIsDrawnInPlace() {
    int found = 0;
    while (find(200, 150, LABEL)) {
      found++;
    }
    assertTrue(found >= 6 && found <= 10, found + " labels");
    assertTrue(find(200, 150, LINE));
    assertEquals(List.of(200.0, 150.0), List.of(positions.left(), positions.base()));
    assertTrue(find(200, 150, MarkStyle.of(Role.LABEL)), "of nothing that has an identity");
    positions.begin(400, 300);
    assertTrue(find(200, 150, LABEL), "in the next picture there is room again");
  }

  @Test
  void labelsNeverOverlapAndAreNotClippedAtTheEdges() {
    SplittableRandom random = new SplittableRandom(5);
    List<Rectangle2D> drawn = new ArrayList<>();
    Rectangle2D picture = new Rectangle2D.Double(0, 0, 400, 300);
    for (int i = 0; i < 300; i++) {
      if (find(random.nextDouble(-50, 450), random.nextDouble(-50, 350), LABEL)) {
        Rectangle2D plate =
            new Rectangle2D.Double(positions.left() - 3, positions.base() - 10, 106, 14);
        assertTrue(picture.contains(plate), plate.toString());
        assertFalse(drawn.stream().anyMatch(other -> other.intersects(plate)), plate.toString());
        drawn.add(plate);
      }
    }
    assertTrue(drawn.size() > 30, drawn.size() + " labels");
  }
}
