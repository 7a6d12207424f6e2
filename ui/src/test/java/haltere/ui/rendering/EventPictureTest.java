package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.Reset;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What the modes make of events. */
class EventPictureTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(16, 8);

  private static PictureStyle style(DisplayMode mode, boolean sharp) {
    return new PictureStyle(mode, ColourMap.DARK, Gradient.CIVIDIS, 1000, sharp);
  }

  private static EventPicture picture(DisplayMode mode, boolean sharp) {
    return new EventPicture(SENSOR, style(mode, sharp));
  }

  private static void event(EventPicture picture, long timeUs, int x, int y, boolean on) {
    EventPacket packet = new EventPacket(1);
    packet.append(timeUs, EventAddress.pack(x, y, on));
    picture.packet(packet);
  }

  private static int pixel(EventPicture picture, int x, int y) {
    int[] argb = new int[SENSOR.pixels()];
    picture.paintRanked(argb);
    PictureScaler.makeOpaque(argb, argb);
    return argb[(SENSOR.height() - 1 - y) * SENSOR.width() + x];
  }

  private static double grey(int argb) {
    return (argb & 0xFF) / 255.0;
  }

  @Test
  void singlePolarityModesHideTheOtherPolarity() {
    EventPicture picture = picture(DisplayMode.ON_ONLY, false);
    event(picture, 100, 3, 2, true);
    event(picture, 100, 4, 2, false);
    assertEquals(ColourMap.DARK.on(), pixel(picture, 3, 2));
    assertEquals(ColourMap.DARK.background(), pixel(picture, 4, 2));
    picture.configure(style(DisplayMode.OFF_ONLY, false));
    assertEquals(ColourMap.DARK.background(), pixel(picture, 3, 2));
    assertEquals(ColourMap.DARK.off(), pixel(picture, 4, 2));
  }

  @Test
  void timeSurfaceShowsAgesOfBothPolarities() {
    EventPicture picture = picture(DisplayMode.TIME_SURFACE, false);
    event(picture, 0, 1, 1, true);
    event(picture, 3000, 2, 1, false);
    event(picture, 3000, 3, 1, true);
    assertEquals(pixel(picture, 2, 1), pixel(picture, 3, 1));
    assertEquals(Gradient.CIVIDIS.colour(1), pixel(picture, 3, 1));
    // half of the six time constants that are shown
    assertEquals(Gradient.CIVIDIS.colour(0.5), pixel(picture, 1, 1));
    picture.advanceTo(50_000);
    assertEquals(Gradient.CIVIDIS.colour(0), pixel(picture, 3, 1));
  }

  @Test
  void flickeringPixelHasTheColourOfItsFrequency() {
    EventPicture picture = picture(DisplayMode.FREQUENCY, true);
    for (int k = 0; k < 5; k++) {
      picture.beginExposure();
      event(picture, 10_000L * k, 3, 2, true);
      event(picture, 10_000L * k + 1000, 3, 2, false);
      event(picture, 10_000L * k + 2000, 4, 2, true);
    }
    assertEquals(100, picture.frequencyHz(3, 2), 1e-6);
    double share = Math.log(100 / 5.0) / Math.log(1000 / 5.0);
    int expected = Gradient.CIVIDIS.colour(share);
    for (int shift = 0; shift < 24; shift += 8) {
      assertEquals(expected >> shift & 0xFF, pixel(picture, 3, 2) >> shift & 0xFF, 2);
    }
    assertEquals(ColourMap.DARK.background(), pixel(picture, 4, 2), "ON events alone");
    picture.advanceTo(300_000);
    assertEquals(ColourMap.DARK.background(), pixel(picture, 3, 2), "silent since");
  }

  @Test
  void intensityIsTheFadingSumOfEvents() {
    SplittableRandom random = new SplittableRandom(4);
    EventPicture picture = picture(DisplayMode.INTENSITY, false);
    double[] times = new double[400];
    double[] signs = new double[400];
    long timeUs = 0;
    for (int i = 0; i < 400; i++) {
      timeUs += random.nextInt(900);
      boolean on = random.nextInt(3) > 0;
      times[i] = timeUs;
      signs[i] = on ? 1 : -1;
      event(picture, timeUs, 5, 5, on);
    }
    for (int i = 0; i < 20; i++) {
      event(picture, timeUs, 2, 2, true);
    }
    picture.advanceTo(timeUs + 300);
    double sum = 0;
    for (int i = 0; i < 400; i++) {
      sum += signs[i] * Math.exp((times[i] - timeUs - 300) / 1000);
    }
    double expected = Math.max(0, Math.min(1, 0.5 + sum / 12));
    assertEquals(expected, grey(pixel(picture, 5, 5)), 0.01);
    assertEquals(0.5, grey(pixel(picture, 6, 5)), 0.01);
  }

  @Test
  void intensityOfSingleEventsHasFullContrast() {
    EventPicture picture = picture(DisplayMode.INTENSITY, true);
    event(picture, 10, 3, 2, true);
    event(picture, 10, 4, 2, false);
    assertEquals(1, grey(pixel(picture, 3, 2)), 0.01);
    assertEquals(0, grey(pixel(picture, 4, 2)), 0.01);
    assertEquals(0.5, grey(pixel(picture, 5, 2)), 0.01);
  }

  @Test
  void heatMapScaleIsRobustToAHotPixel() {
    EventPicture picture = picture(DisplayMode.COUNTS, true);
    for (int x = 0; x < 16; x++) {
      for (int y = 0; y < 8; y++) {
        for (int n = 0; n <= x; n++) {
          event(picture, 10, x, y, n % 2 == 0);
        }
      }
    }
    int most = pixel(picture, 15, 3);
    assertEquals(16, picture.fullCount(), 0.5);
    assertEquals(Gradient.CIVIDIS.colour(1), most);
    assertTrue(picture.fullCount() > 0);
    picture.beginExposure();
    event(picture, 20, 0, 0, true);
    assertEquals(Gradient.CIVIDIS.colour(0), pixel(picture, 15, 3), "another exposure");
    assertEquals(1, picture.fullCount(), 1e-9);
  }

  @Test
  void exposureShowsItsEventsWithoutFading() {
    EventPicture picture = picture(DisplayMode.POLARITY, true);
    event(picture, 0, 1, 1, true);
    event(picture, 900, 2, 1, true);
    picture.advanceTo(1500);
    assertEquals(ColourMap.DARK.background(), pixel(picture, 1, 1));
    assertEquals(ColourMap.DARK.on(), pixel(picture, 2, 1));
  }

  @Test
  void seekClearsThePictureAndAChangeOfFadingDoesNot() {
    EventPicture picture = picture(DisplayMode.INTENSITY, false);
    for (int i = 0; i < 4; i++) {
      event(picture, 100, 7, 7, true);
    }
    double before = grey(pixel(picture, 7, 7));
    picture.configure(
        new PictureStyle(DisplayMode.INTENSITY, ColourMap.DARK, Gradient.CIVIDIS, 50_000, false));
    assertEquals(before, grey(pixel(picture, 7, 7)), 0.01);
    picture.notified(new Reset(Reset.Cause.SEEK));
    assertEquals(0.5, grey(pixel(picture, 7, 7)), 0.01);
  }

  @Test
  void gradientsAreMonotonicInLightness() {
    for (Gradient gradient : Gradient.all()) {
      double before = lightness(gradient.colour(0));
      double way = Math.signum(lightness(gradient.colour(1)) - before);
      for (int i = 1; i <= 20; i++) {
        double now = lightness(gradient.colour(i / 20.0));
        assertTrue((now - before) * way >= -1, gradient.name() + " at " + i / 20.0);
        before = now;
      }
    }
  }

  private static double lightness(int argb) {
    return 0.299 * (argb >> 16 & 0xFF) + 0.587 * (argb >> 8 & 0xFF) + 0.114 * (argb & 0xFF);
  }
}
