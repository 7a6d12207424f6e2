package haltere.ui.viewer.space;

import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.ui.space.BodyFlight;
import haltere.ui.space.SimulatedFlight;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.controls.Theme;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import javafx.scene.Scene;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.image.WritableImage;
import javafx.stage.Stage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BodyFlightPaneTest {
  @TempDir Path folder;

  @Test
  void sliderSelectsTheDisplayedTime() throws IOException {
    BodyFlight flight = SimulatedFlight.in(folder).load();
    try (ViewerHarness viewer = new ViewerHarness()) {
      BodyFlightPane pane = viewer.onFx(() -> new BodyFlightPane(flight, Theme.DARK));
      Stage stage =
          viewer.onFx(
              () -> {
                Stage made = new Stage();
                made.setScene(new Scene(pane, 600, 450));
                made.show();
                return made;
              });
      Label text = viewer.onFx(() -> (Label) pane.lookup("#flight-words"));
      String first = viewer.onFx(text::getText);
      WritableImage before = viewer.onFx(() -> pane.snapshot(null, null));
      viewer.onFx(
          () -> {
            ((Slider) pane.lookup("#flight-time")).setValue(60);
            return null;
          });
      assertNotEquals(first, viewer.onFx(text::getText));
      WritableImage after = viewer.onFx(() -> pane.snapshot(null, null));
      Set<Integer> colours = new HashSet<>();
      int changed = 0;
      for (int y = 0; y < 400; y++) {
        for (int x = 0; x < 600; x++) {
          int colour = after.getPixelReader().getArgb(x, y);
          colours.add(colour);
          changed += colour == before.getPixelReader().getArgb(x, y) ? 0 : 1;
        }
      }
      assertTrue(colours.size() > 3, colours.size() + " colours");
      assertTrue(changed > 50, changed + " pixels changed");
      viewer.onFx(
          () -> {
            stage.close();
            return null;
          });
    }
  }
}
