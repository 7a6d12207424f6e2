package haltere.ui.viewer.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.ui.viewer.ViewerHarness;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Labeled;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class WarningBannerTest {
  private static final List<String> CUT = List.of("the file is cut off");

  private final ViewerHarness viewer = new ViewerHarness();
  private final WarningBanner banner = viewer.onFx(() -> new WarningBanner(sensor -> {}));

  @AfterEach
  void close() {
    viewer.close();
  }

  private boolean isSeenAfter(List<String> warnings, Optional<SensorGeometry> guess) {
    viewer.run(() -> banner.show(warnings, guess));
    return viewer.onFx(banner::isVisible);
  }

  @Test
  void dismissedWarningsReappearOnlyWithNewOnes() {
    assertTrue(isSeenAfter(CUT, Optional.empty()));
    viewer.run(banner::hide);
    assertFalse(isSeenAfter(CUT, Optional.empty()));
  }

  private Labeled part(String id) {
    return (Labeled) banner.lookup("#" + id);
  }

  @Test
  void severalWarningsAreOpenedAndASingleOneIsWhole() {
    assertTrue(isSeenAfter(CUT, Optional.empty()));
    assertEquals("The file is cut off", part("warning-first").getText());
    assertFalse(part("warnings-more").isVisible());
    assertTrue(isSeenAfter(List.of(CUT.get(0), "no camera is named"), Optional.empty()));
    assertTrue(part("warnings-more").isVisible());
    viewer.run(() -> ((Hyperlink) part("warnings-more")).fire());
    assertEquals("2 warnings", part("warning-first").getText());
    assertEquals("Less", part("warnings-more").getText());
  }

  @Test
  void newWarningsAndQuestionsAreShownAfterADismissal() {
    assertTrue(isSeenAfter(CUT, Optional.empty()));
    viewer.run(banner::hide);
    assertTrue(isSeenAfter(List.of(CUT.get(0), "no camera is named"), Optional.empty()));
    viewer.run(banner::hide);
    assertTrue(isSeenAfter(CUT, Optional.of(new SensorGeometry(128, 128))));
  }

  @Test
  void warningsOfTheNextFileAreShown() {
    assertTrue(isSeenAfter(CUT, Optional.empty()));
    viewer.run(banner::hide);
    assertFalse(isSeenAfter(List.of(), Optional.empty()));
    assertTrue(isSeenAfter(CUT, Optional.empty()));
  }
}
