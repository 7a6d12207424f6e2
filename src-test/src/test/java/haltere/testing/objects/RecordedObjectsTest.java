package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.testing.Recorded;
import java.io.IOException;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The object tracker with its default settings on real recordings of one object. */
class RecordedObjectsTest {
  private static final String WALKING = "dvs128-walking-10s.aedat";

  private static LabelledRecording recording(String file) {
    Recorded.file(file);
    return LabelledRecording.all().stream()
        .filter(recording -> recording.file().equals(file))
        .findFirst()
        .orElseThrow();
  }

  private static ObjectScore score(ObjectScene scene) throws IOException {
    List<TrackRow> rows =
        new ChainTracker(List.of("object-tracker"), "objects")
            .track(scene.name(), scene.events().open());
    return ObjectScore.of(scene, rows);
  }

  private static void assertOneTrack(Footage footage, double minIdf1) throws IOException {
    ObjectScore score = score(footage.scene("one object", "recording"));
    assertTrue(score.idf1() >= minIdf1, score.toString());
    assertTrue(score.tracksOnIt() <= 1.1, score.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"dvs128-pendulum.aedat", WALKING, "dvs128-moving-dark-box.aedat"})
  void oneObjectIsOneTrack(String file) throws IOException {
    assertOneTrack(recording(file).footage(), 0.9);
  }

  @ParameterizedTest
  @ValueSource(strings = {"dvs128-pendulum.aedat", WALKING, "dvs128-moving-dark-box.aedat"})
  void labelsAreWithinTheStatedDeviations(String file) throws IOException {
    ObjectScore score = score(recording(file).scene());
    // near 95 %: boxes are labelled to some pixels, and motion has no constant statistics
    assertTrue(score.position().share() > 0.9, score.toString());
    assertTrue(score.velocity().share() > 0.85, score.toString());
  }

  @Test
  void personWhoWalksInPlaceIsOneTrackInNoise() throws IOException {
    Footage person = recording(WALKING).footage();
    assertOneTrack(person.withNoise(2, new SplittableRandom(1)), 0.8);
  }

  @Test
  void personWhoWalksInPlaceIsOneTrackInSlowMotion() throws IOException {
    assertOneTrack(recording(WALKING).footage().stretched(4), 0.8);
  }
}
