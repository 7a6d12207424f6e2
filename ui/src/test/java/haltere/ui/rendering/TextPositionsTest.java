package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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

  private Optional<Rectangle2D> find(double left, double base, MarkStyle style) {
    return positions.find(left, base, 100, 10, 4, 3, style);
  }

  private List<Double> found(double left, double base, MarkStyle style) {
    Rectangle2D plate = find(left, base, style).orElseThrow();
    return List.of(plate.getX() + 3, plate.getY() + 10);
  }

  @Test
  void laterLabelMovesAsideOfAnEarlierOne() {
    assertEquals(List.of(200.0, 150.0), found(200, 150, LABEL));
    assertEquals(List.of(210.0, 136.0), found(210, 150, LABEL), "above");
    assertEquals(List.of(205.0, 164.0), found(205, 150, LABEL), "below");
    assertEquals(List.of(93.0, 150.0), found(205, 150, LABEL), "to the left");
  }

  @Test
  void labelWithoutSpaceIsOmittedAndOtherTextIsDrawnInPlace() {
    int found = 0;
    while (find(200, 150, LABEL).isPresent()) {
      found++;
    }
    assertTrue(found >= 6 && found <= 10, found + " labels");
    assertEquals(List.of(200.0, 150.0), found(200, 150, LINE));
    assertTrue(
        find(200, 150, MarkStyle.of(Role.LABEL)).isPresent(), "of nothing that has an identity");
    positions.begin(400, 300);
    assertTrue(find(200, 150, LABEL).isPresent(), "in the next picture there is room again");
  }

  @Test
  void labelsNeverOverlapAndAreNotClippedAtTheEdges() {
    SplittableRandom random = new SplittableRandom(5);
    List<Rectangle2D> drawn = new ArrayList<>();
    Rectangle2D picture = new Rectangle2D.Double(0, 0, 400, 300);
    for (int i = 0; i < 300; i++) {
      Optional<Rectangle2D> found =
          find(random.nextDouble(-50, 450), random.nextDouble(-50, 350), LABEL);
      found.ifPresent(
          plate -> {
            assertTrue(picture.contains(plate), plate.toString());
            assertFalse(
                drawn.stream().anyMatch(other -> other.intersects(plate)), plate.toString());
            drawn.add(plate);
          });
    }
    assertTrue(drawn.size() > 30, drawn.size() + " labels");
  }
}
