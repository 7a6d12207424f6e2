package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.DefaultChain;
import haltere.filters.estimation.Angles;
import haltere.filters.estimation.ConstMatrix;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

class WingOverlayTest {
  private static final FlySceneSettings FLY = FlySceneSettings.defaults().with("run.durationS=4");

  /** Writes down the marks. */
  private static final class Marks implements OverlayCanvas {
    final List<String> all = new ArrayList<>();
    final List<double[]> lines = new ArrayList<>();
    final Map<String, double[]> texts = new HashMap<>();

    @Override
    public void circle(double x, double y, double radius, MarkStyle style) {
      all.add("circle " + style.role());
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
      all.add("line " + style.role());
      lines.add(new double[] {x1, y1, x2, y2});
    }

    @Override
    public void polyline(double[] x, double[] y, int points, MarkStyle style) {
      all.add("arc " + style.role());
    }

    @Override
    public void ellipse(
        double x, double y, double radiusA, double radiusB, double angleRad, MarkStyle style) {
      all.add("ellipse " + style.role());
    }

    @Override
    public void rectangle(double x, double y, double width, double height, MarkStyle style) {
      all.add("rectangle " + style.role());
    }

    @Override
    public void text(double x, double y, String text, MarkStyle style) {
      all.add(text);
      texts.put(text, new double[] {x, y});
    }
  }

  private static Marks draw(double left, double right) {
    FlyGeometry fly = new FlyGeometry(50, 60, Math.PI / 2, 40, 47, 60, 53, 60, 0.9, 0);
    Marks marks = new Marks();
    new WingOverlay()
        .draw(
            new WingSnapshot(
                0,
                WingTrackerState.Phase.TRACKING,
                fly,
                42,
                ConstMatrix.column(left, left, right, right),
                ConstMatrix.column(200, 200),
                ConstMatrix.column(0.02, 0.02)),
            marks);
    return marks;
  }

  @Test
  void overlayShowsBodyHingesRegionEdgesAndUncertainty() {
    Marks marks = draw(1.5, 1.6);
    assertEquals(2, marks.all.stream().filter("line LEFT"::equals).count());
    assertEquals(2, marks.all.stream().filter("line RIGHT"::equals).count());
    assertEquals(2, marks.all.stream().filter("arc UNCERTAINTY"::equals).count());
    assertTrue(marks.all.contains("ellipse OBJECT"));
    assertTrue(marks.all.contains("circle REGION"));
    assertTrue(marks.all.contains("head 90 %"));
  }

  @Test
  void lettersAreOutsideTheCircleOfTheRegion() {
    Marks marks = draw(1.5, 1.6);
    assertTrue(marks.texts.get("L")[0] + 4 < 50 - 42, "with room for the letter");
    assertTrue(marks.texts.get("R")[0] > 50 + 42);
  }

  @Test
  void wingAtARightAngleToTheHeadingPointsToItsSide() {
    Marks marks = draw(Math.PI / 2, Math.PI / 2);
    double[] left = marks.lines.get(1);
    double[] right = marks.lines.get(3);
    assertEquals(47 - 40, left[2], 1e-9);
    assertEquals(60, left[3], 1e-9);
    assertEquals(53 + 40, right[2], 1e-9);
  }

  @Test
  void lostWingsShowOnlyTheirStatus() {
    FlyGeometry fly = new FlyGeometry(50, 60, Math.PI / 2, 40, 47, 60, 53, 60, 0.9, 0);
    ConstMatrix none = ConstMatrix.column(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    Marks marks = new Marks();
    new WingOverlay()
        .draw(
            new WingSnapshot(
                0,
                WingTrackerState.Phase.LOST,
                fly,
                42,
                none,
                ConstMatrix.column(200, 200),
                ConstMatrix.column(0.02, 0.02)),
            marks);
    assertEquals(List.of("wings lost"), marks.all);
  }

  @Test
  void wingLinesFollowTheSimulatedWings() throws IOException {
    List<Double> drawn = lineErrors(DefaultChain.forFly(new FlyScene(FLY).geometry()));
    assertTrue(shareWithin(1.5, drawn) > 0.97, "97 % are within 1.5 degrees");
    assertTrue(shareWithin(2, drawn) > 0.995, "nearly all are within 2 degrees");
    assertTrue(shareWithin(3.5, drawn) == 1, "no line jumps");
    FilterChain often = DefaultChain.forFly(new FlyScene(FLY).geometry());
    often.apply(
        often.stage("wing-tracker"), WingTrackerSettings.defaults().with("output.rateHz=20000"));
    double estimated = shareWithin(1.5, lineErrors(often));
    assertTrue(estimated < 0.99, "the estimates themselves are not always");
    assertEquals(estimated, shareWithin(1.5, drawn), 0.01, "the time between two adds little");
  }

  private static double shareWithin(double degrees, List<Double> errors) {
    return errors.stream().filter(error -> error <= degrees).count() / (double) errors.size();
  }

  /** Between the drawn lines and the wings, after random events of the second 1 to 4, degrees. */
  private static List<Double> lineErrors(FilterChain chain) throws IOException {
    FlyScene scene = new FlyScene(FLY);
    WingSnapshot[] last = new WingSnapshot[1];
    chain.outlet("snapshot", WingSnapshot.class).subscribe(snapshot -> last[0] = snapshot);
    List<Double> errors = new ArrayList<>();
    Random random = new Random(1);
    while (scene.next(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            int from = 0;
            while (from < packet.size()) {
              int to = Math.min(packet.size(), from + 1 + random.nextInt(200));
              chain.process(EventPackets.part(packet, from, to));
              compare(packet.timeUs(to - 1));
              from = to;
            }
          }

          private void compare(long timeUs) {
            if (timeUs < 1_000_000) {
              return;
            }
            // events carry the time of the wing and the constant delay of the pixels
            FlyTruth truth = scene.truthAt(timeUs - 60);
            double aheadS = Overlay.aheadS(last[0].timeUs(), timeUs);
            double turned = last[0].geometry().headingRad() - truth.headingRad();
            errors.add(error(aheadS, 0, truth.leftAngleRad() - turned));
            errors.add(error(aheadS, 2, truth.rightAngleRad() + turned));
          }

          /** Of the middle between both edges of a wing, degrees. */
          private double error(double aheadS, int edge, double angleRad) {
            double leading = last[0].edgeRad(edge, aheadS);
            double middle = (leading + last[0].edgeRad(edge + 1, aheadS)) / 2;
            return Math.toDegrees(Math.abs(Angles.wrapPi(middle - angleRad)));
          }

          @Override
          public void notified(StreamNotification notification) {}
        })) {
      // until its end
    }
    return errors;
  }

  @Test
  void untrackedWingsAreNotDrawn() {
    Marks marks = draw(1.5, Double.NaN);
    assertEquals(0, marks.all.stream().filter("line RIGHT"::equals).count());
  }
}
