package haltere.ui.command.terminal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class ProgressBarTest {
  private final ByteArrayOutputStream terminal = new ByteArrayOutputStream();
  private long nanos = 5_000_000_000L;

  private ProgressBar bar(boolean shown) {
    return new ProgressBar(
        new PrintStream(terminal, true, StandardCharsets.UTF_8), shown, "reading x", () -> nanos);
  }

  /** What the terminal shows, which interprets the codes to wrap lines or not. */
  private String screen() {
    return terminal.toString(StandardCharsets.UTF_8).replaceAll("\u001b\\[\\?7[lh]", "");
  }

  @Test
  void barShowsShareRateAndRemainingTime() {
    ProgressBar bar = bar(true);
    nanos += 10_000_000_000L;
    bar.progress(250_000_000, 1_000_000_000);
    assertEquals("\rreading x [======>                 ]  25 %  25 MB/s  0:30 left", screen());
  }

  @Test
  void barShowsEventsIfTheyAreCounted() {
    ProgressBar bar = bar(true);
    nanos += 2_000_000_000L;
    bar.events(30_000_000);
    bar.progress(1, 2);
    assertTrue(screen().contains("15.0 Mev/s"), screen());
  }

  @Test
  void barIsDrawnAtMostTenTimesASecond() {
    ProgressBar bar = bar(true);
    for (int i = 0; i < 1000; i++) {
      nanos += 1_000_000;
      bar.progress(i, 1000);
    }
    assertEquals(10, screen().chars().filter(c -> c == '\r').count());
  }

  @Test
  void barStaysOnOneLineAndIsErasedAtTheEnd() {
    ProgressBar bar = bar(true);
    nanos += 1_000_000_000L;
    bar.progress(1, 100);
    bar.close();
    assertFalse(screen().contains("\n"));
    assertTrue(screen().endsWith(" \r"), screen());
    assertTrue(screen().lines().allMatch(line -> line.length() < 80), screen());
  }

  @Test
  void narrowTerminalCutsTheBarOffInsteadOfWrappingIt() {
    ProgressBar bar = bar(true);
    for (int i = 1; i < 4; i++) {
      nanos += 1_000_000_000L;
      bar.progress(i, 4);
    }
    bar.close();
    for (String drawn : terminal.toString(StandardCharsets.UTF_8).split("(?=\u001b\\[\\?7l)")) {
      assertTrue(drawn.matches("\u001b\\[\\?7l\r[^\r]*\u001b\\[\\?7h\r?"), drawn);
    }
  }

  @Test
  void longNameIsShortenedToTheWidthOfTheLine() {
    String label = "tracking dvs128-moving-dark-box-second-session-0042.aedat";
    ProgressBar bar =
        new ProgressBar(
            new PrintStream(terminal, true, StandardCharsets.UTF_8), true, label, () -> nanos);
    nanos += 1_000_000_000L;
    bar.events(30_000_000);
    bar.progress(1, 2);
    assertTrue(screen().contains("tracking dvs128-mo\u2026"), screen());
    assertTrue(screen().contains("-session-0042.aedat ["), screen());
    assertTrue(screen().strip().length() < 80, screen());
  }

  @Test
  void noBarAppearsWithoutATerminal() {
    ProgressBar bar = bar(false);
    nanos += 1_000_000_000L;
    bar.progress(1, 2);
    bar.close();
    assertEquals("", screen());
  }

  @Test
  void unknownTotalIsHandled() {
    ProgressBar bar = bar(true);
    nanos += 1_000_000_000L;
    bar.progress(0, 0);
    assertTrue(screen().contains("  0 %"), screen());
  }
}
