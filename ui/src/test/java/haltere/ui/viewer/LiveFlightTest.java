package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.FlightScene;
import haltere.core.simulation.FlightSettings;
import haltere.core.simulation.FlightTruth;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.CameraRig;
import haltere.ui.space.LiveFlight;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javafx.scene.control.Label;
import org.junit.jupiter.api.Test;

class LiveFlightTest {
  private static final FlightSettings SETTINGS =
      FlightSettings.defaults().with("run.durationS=0.8", "view.cameras=2", "run.seed=11");

  /** Plays a rig through as a player does. */
  private static BodyFlight play(CameraRig rig, LiveFlight live) throws IOException {
    while (rig.first().next(live)) {
      // until the end
    }
    live.sliceEnd(0, 1);
    return live.latest();
  }

  @Test
  void theAxisOfASimulatedBodyIsFoundWhileTwoEventCamerasPlay() throws IOException {
    FlightScene scene = new FlightScene(SETTINGS);
    try (CameraRig rig = CameraRig.simulated(SETTINGS)) {
      LiveFlight live = new LiveFlight(rig);
      BodyFlight flight = play(rig, live);
      assertEquals(2, flight.cameras().size());
      List<Double> errorsDeg = new ArrayList<>();
      for (BodyFlight.Moment moment : flight.moments()) {
        FlightTruth truth = scene.truthAt(moment.estimate().timeUs());
        double along =
            moment.estimate().ux() * truth.ux()
                + moment.estimate().uy() * truth.uy()
                + moment.estimate().uz() * truth.uz();
        errorsDeg.add(Math.toDegrees(Math.acos(Math.min(1, along))));
        assertEquals(2, moment.residualsDeg().size());
      }
      assertTrue(errorsDeg.size() > 30, errorsDeg.size() + " moments");
      Collections.sort(errorsDeg);
      double median = errorsDeg.get(errorsDeg.size() / 2);
      assertTrue(median < 8, "median " + median);
      rig.first().seek(0);
      assertEquals(flight, play(rig, live), "from the start again");
    }
  }

  @Test
  void theWindowShowsTheFlightWhileItPlays() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      LiveFlightFeature feature = viewer.window.feature(LiveFlightFeature.class);
      viewer.run(feature::openScene);
      viewer.waitFor(
          "an orientation",
          () ->
              viewer.stage.getScene().lookup("#live-flight-words") instanceof Label words
                  && words.getText().contains("axis"));
      String words = viewer.onFx(() -> viewer.node("live-flight-words", Label.class).getText());
      viewer.waitFor(
          "another one",
          () -> !viewer.node("live-flight-words", Label.class).getText().equals(words));
    }
  }
}
