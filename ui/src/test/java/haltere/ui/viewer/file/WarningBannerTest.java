package haltere.ui.viewer.file;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.ui.viewer.ViewerHarness;
import java.util.List;
import java.util.Optional;
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
