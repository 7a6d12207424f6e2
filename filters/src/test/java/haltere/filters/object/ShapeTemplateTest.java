package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class ShapeTemplateTest {
  private final SplittableRandom random = new SplittableRandom(1);

  private ShapeTemplate box(double halfX, double halfY) {
    ShapeTemplate template = new ShapeTemplate();
    template.clear(2);
    for (int i = 0; i < 2000; i++) {
      template.spread(
          halfX * (2 * random.nextDouble() - 1), halfY * (2 * random.nextDouble() - 1), 1, 1);
    }
    template.refresh();
    return template;
  }

  @Test
  void densitySumsToOne() {
    double sum = 0;
    for (float density : box(10, 6).density) {
      sum += density;
    }
    assertEquals(1, sum, 0.01);
  }

  @Test
  void extentCoversTheEvents() {
    ShapeTemplate template = box(10, 6);
    assertEquals(10, template.halfX, 1.5);
    assertEquals(6, template.halfY, 1.5);
    assertEquals(0, template.middleX, 0.5);
    assertEquals(100 / 3.0, template.varianceX, 4);
    assertEquals(36 / 3.0, template.varianceY, 2);
  }

  @Test
  void gradientEstimatesADisplacementWithTheVarianceOfItsInformation() {
    double squares = 0;
    double stated = 0;
    for (int trial = 0; trial < 200; trial++) {
      ShapeTemplate template = box(10, 6);
      double shift = random.nextDouble() - 0.5;
      double gradient = 0;
      int events = 300;
      for (int i = 0; i < events; i++) {
        int cell =
            template.cell(
                shift + 10 * (2 * random.nextDouble() - 1), 6 * (2 * random.nextDouble() - 1));
        gradient -= template.gradientX[cell];
      }
      double error = gradient / (events * template.infoXx) - shift;
      squares += error * error / 200;
      stated += 1 / (events * template.infoXx) / 200;
    }
    // what Component takes for the variance is twice the information's
    assertTrue(squares < 2 * stated, squares + " px2 where " + stated + " is stated");
  }

  @Test
  void edgeIsMostInformativeAcrossIt() {
    ShapeTemplate edge = new ShapeTemplate();
    edge.clear(2);
    for (int i = 0; i < 3000; i++) {
      edge.spread(random.nextDouble(), 40 * (random.nextDouble() - 0.5), 1, 1);
    }
    edge.refresh();
    assertTrue(edge.infoXx > 5 * edge.infoYy, edge.infoXx + " and " + edge.infoYy);
  }

  @Test
  void decayKeepsRatiosOfWeights() {
    ShapeTemplate template = new ShapeTemplate();
    template.clear(2);
    int cell = template.cell(0, 0);
    template.add(cell, 8);
    template.decay(0.5);
    template.add(cell, 1);
    template.decay(0.5);
    assertEquals(2.5, ShapeTemplate.sum(template.mass), 1e-6);
  }

  @Test
  void resamplingPreservesWeightCentreAndExtent() {
    ShapeTemplate template = box(10, 6);
    template.resample(template.coarser(), 3, -2);
    template.refresh();
    assertEquals(2000, ShapeTemplate.sum(template.mass), 1);
    assertEquals(-3, template.middleX, 0.7);
    assertEquals(2, template.middleY, 0.7);
    assertEquals(10, template.halfX, 2);
  }

  @Test
  void boxDistanceIsTheGapBetweenBoxes() {
    Component one = component();
    Component other = component();
    double blur = 3 * one.shape.cellPx;
    other.state.setMean(0, 5);
    assertEquals(0, one.boxDistance(other));
    other.state.setMean(0, 30);
    assertEquals(18, one.boxDistance(other), blur);
    other.state.setMean(2, -30);
    assertEquals(18 * Math.sqrt(2), one.boxDistance(other), blur);
    assertEquals(one.boxDistance(other), other.boxDistance(one), 1e-9);
  }

  private Component component() {
    Component component = new Component(0);
    ShapeTemplate box = box(6, 6);
    component.shape.clear(box.cellPx);
    component.shape.spread(box.mass, box.cellPx, 0, 0);
    component.shape.refresh();
    return component;
  }

  @Test
  void cellsThatShrinkWithTheirObjectAreResampledOnceInAStep() {
    ShapeTemplate template = box(10, 6);
    double finest = ShapeTemplate.MIN_CELL_PX;
    template.grow(finest / template.cellPx);
    template.refresh();
    assertEquals(finest, template.wantedCell());
    template.grow(0.98);
    template.refresh();
    assertEquals(template.cellPx, template.wantedCell());
    template.grow(0.7);
    template.refresh();
    assertEquals(finest, template.wantedCell());
  }
}
