package haltere.ui.command.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.Cameras;
import haltere.device.simulated.SimulatedCameraProvider;
import haltere.testing.ManualClock;
import haltere.testing.StreamRecorder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class LiveStatusTest {
  private static final long MS = 1_000_000;

  private final ManualClock time = new ManualClock();
  private final Cameras cameras =
      new Cameras(List.of(new SimulatedCameraProvider(time, () -> time)));
  private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();
  private final StreamRecorder taken = new StreamRecorder();

  private LiveStatus status(boolean shown, Camera... open) {
    PrintStream err = new PrintStream(terminal, true, StandardCharsets.UTF_8);
    return new LiveStatus(err, shown, List.of(open), time);
  }

  private Camera fly() throws IOException {
    return cameras.open("simulated:fly", CameraOptions.DEFAULT);
  }

  /** What the terminal shows, which interprets the codes to wrap lines or not. */
  private String screen() {
    return terminal.toString(StandardCharsets.UTF_8).replaceAll("\u001b\\[\\?7[lh]", "");
  }

  private void take(Camera camera, long ms) throws IOException {
    long until = time.getAsLong() + ms * MS;
    while (time.getAsLong() < until) {
      camera.next(taken);
    }
  }

  @Test
  void statusLineShowsRateLossAndBacklog() throws IOException {
    try (Camera camera = fly();
        LiveStatus status = status(true, camera)) {
      take(camera, 300);
      time.advance(60_800 * MS);
      status.show();

      assertTrue(screen().startsWith("\r1:01  simulated:fly "), screen());
      assertTrue(screen().contains("ev/s, 0 lost, 0 waiting, median latency "), screen());
      int length = screen().length();
      status.show();
      assertEquals(length, screen().length(), "not twice within a tenth of a second");
    }
    assertTrue(screen().endsWith(" \r"), "it is taken away at the end");
  }

  @Test
  void rateIsThatOfTheLatestInterval() throws IOException {
    try (Camera camera = fly();
        LiveStatus status = status(true, camera)) {
      take(camera, 1000);
      status.show();
      time.advance(1000 * MS);
      status.show();

      assertTrue(screen().contains("simulated:fly 0.00 ev/s"), screen());
    }
  }

  @Test
  void noStatusLineAppearsWithoutATerminal() throws IOException {
    try (Camera camera = fly();
        LiveStatus status = status(false, camera)) {
      take(camera, 1000);
      status.show();
    }
    assertEquals("", screen());
  }
}
