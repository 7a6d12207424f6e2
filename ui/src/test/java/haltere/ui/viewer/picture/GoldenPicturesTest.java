package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.DefaultChain;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionMeasurement;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.BlobSource;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import org.junit.jupiter.api.Test;

/** What is drawn over and of events, against pictures that a person has looked at. */
class GoldenPicturesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  /** What a chain and its overlays look like some time into a stream. */
  private static BufferedImage picture(
      EventSource source, FilterChain chain, DisplayOptions options, long untilUs)
      throws IOException {
    DisplaySink display = DisplaySink.direct(source.geometry(), chain, options);
    long[] nowUs = {0};
    StreamHandler handler =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            nowUs[0] = packet.timesUs()[packet.size() - 1];
            chain.process(packet);
            display.packet(packet);
          }

          @Override
          public void notified(StreamNotification notification) {
            chain.notified(notification);
            display.notified(notification);
          }
        };
    display.paint();
    while (nowUs[0] < untilUs && source.next(handler)) {
      // the handler counts
    }
    display.endSlice(nowUs[0], nowUs[0]);
    BufferedImage image = display.picture(PictureRendererTest.MARKS_ALONE);
    display.close();
    chain.close();
    source.close();
    return image;
  }

  private static DisplayOptions options(DisplayMode mode, ColourMap colours) {
    return new DisplayOptions(mode, colours, Gradient.CIVIDIS, 30_000, 0);
  }

  @Test
  void objectMarksOfTheBlobMatch() throws IOException {
    GoldenPictures.check(
        "object",
        picture(
            new BlobSource(Long.MAX_VALUE),
            DefaultChain.create(SENSOR),
            options(DisplayMode.POLARITY, ColourMap.DARK),
            1_000_000));
  }

  @Test
  void wingMarksOfTheFlyMatch() throws IOException {
    FlyScene scene = new FlyScene(FlySceneSettings.defaults());
    GoldenPictures.check(
        "wings",
        picture(
            scene,
            DefaultChain.forFly(scene.geometry()),
            options(DisplayMode.POLARITY, ColourMap.LIGHT),
            150_000));
  }

  @Test
  void heatMapOfTheBlobMatches() throws IOException {
    GoldenPictures.check(
        "heat-map",
        picture(
            new BlobSource(Long.MAX_VALUE),
            new FilterChain(SENSOR),
            options(DisplayMode.COUNTS, ColourMap.DARK),
            500_000));
  }

  @Test
  void allKindsOfMarksMatch() throws IOException {
    for (boolean dark : new boolean[] {true, false}) {
      int[] argb = new int[SENSOR.pixels()];
      Arrays.fill(argb, (dark ? ColourMap.DARK : ColourMap.LIGHT).background());
      GoldenPictures.check(
          dark ? "marks-dark" : "marks-light",
          Pictures.draw(SENSOR, argb, dark, 6, GoldenPicturesTest::drawMarks));
    }
  }

  private static void drawMarks(OverlayCanvas canvas) {
    int y = 8;
    for (Role role : Role.values()) {
      MarkStyle style = MarkStyle.of(role, y);
      canvas.circle(10, y, 3, style);
      canvas.line(18, y - 3, 30, y + 3, style);
      canvas.ellipse(40, y, 6, 3, 0.5, style);
      canvas.rectangle(50, y - 3, 10, 6, style);
      canvas.polyline(new double[] {66, 72, 78}, new double[] {y, y + 3, y - 3}, 3, style);
      canvas.text(84, y - 1, role.name().toLowerCase(Locale.ROOT), style);
      y += 10;
    }
  }

  @Test
  void tapeAndRegionMatch() throws IOException {
    MeasuringTape tape = new MeasuringTape(new SimpleObjectProperty<>(Optional.empty()));
    tape.pressed(10, 20);
    tape.dragged(70, 60);
    RegionMarks region =
        new RegionMarks(
            PixelRegion.between(60, 80, 100, 110),
            new RegionMeasurement(12_340, 0.5, 187.3, 800_000));
    int[] argb = new int[SENSOR.pixels()];
    Arrays.fill(argb, ColourMap.DARK.background());
    GoldenPictures.check(
        "tape-and-region",
        Pictures.draw(
            SENSOR,
            argb,
            true,
            6,
            canvas -> {
              tape.draw(canvas);
              region.draw(canvas);
            }));
  }

  @Test
  void displacedOrMissingMarkIsDetected() {
    int[] argb = new int[SENSOR.pixels()];
    Arrays.fill(argb, ColourMap.DARK.background());
    BufferedImage here = circle(argb, 60);
    assertEquals(0, GoldenPictures.unlike(here, circle(argb, 60.2)));
    assertTrue(GoldenPictures.unlike(here, circle(argb, 66)) > 0.004);
    assertTrue(
        GoldenPictures.unlike(here, Pictures.draw(SENSOR, argb, true, 6, canvas -> {})) > 0.004);
  }

  private static BufferedImage circle(int[] argb, double x) {
    return Pictures.draw(
        SENSOR, argb, true, 6, canvas -> canvas.circle(x, 60, 30, MarkStyle.of(Role.OBJECT)));
  }
}
