package haltere.ui.viewer.controls;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.NoSuchFileException;
import java.util.OptionalLong;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;

class TextsTest {
  private static PlayerStatus late(String slowestStage, double sourceShare) {
    return new PlayerStatus(
        State.PLAYING,
        0,
        0,
        -1,
        1,
        0.5,
        1_200_000,
        slowestStage,
        sourceShare,
        0,
        0,
        0,
        0,
        1,
        0,
        "",
        0);
  }

  @Test
  void unreachedSpeedIsShownBesideTheReachedOne() {
    assertEquals("0.50\u00d7 of 1\u00d7", Texts.reached(late("dawdler", 0.2)));
    assertEquals("Most of the time goes to Dawdler.", Texts.limit(late("dawdler", 0.2)));
    assertEquals("", Texts.limit(late("", 0)));
    String source = Texts.limit(late("dawdler", 0.8));
    assertTrue(source.startsWith("Reading or simulating the source"), source);
  }

  @Test
  void speedsAreWrittenAsSharesOfRealTime() {
    assertEquals("1/1000\u00d7", Texts.speed(1e-3));
    assertEquals("16\u00d7", Texts.speed(16));
    assertEquals("0\u00d7", Texts.speed(0));
    assertEquals("max", Texts.speed(Double.POSITIVE_INFINITY));
  }

  @Test
  void timesAreParsedInCommonNotations() {
    assertEquals(OptionalLong.of(62_345_000), Texts.parseTime("1:02.345"));
    assertEquals(OptionalLong.of(3_723_500_000L), Texts.parseTime("1:02:03.5"));
    assertEquals(OptionalLong.of(250_000), Texts.parseTime(" 250 ms"));
    assertEquals(OptionalLong.of(1500), Texts.parseTime("1500us"));
    assertEquals(OptionalLong.of(3_000_000), Texts.parseTime("3"));
    assertEquals(OptionalLong.empty(), Texts.parseTime("soon"));
    assertEquals(OptionalLong.empty(), Texts.parseTime("-3 s"));
  }

  @Test
  void optionsOfTheCommandLineAreLeftOutOrNamedWithTheirCommand() {
    assertEquals(
        "its size was taken from the events",
        Texts.withoutOptions("its size was taken from the events (--sensor WxH states it)"));
    assertEquals(
        "state the sensor's size with haltere view --sensor WxH",
        Texts.withoutOptions("state the sensor's size with --sensor WxH"));
    assertEquals(
        "/a and /b are read; haltere view --topic chooses another: /c",
        Texts.withoutOptions("/a and /b are read; --topic chooses another: /c"));
    assertEquals(
        "it is not AEDAT-3; leave out --format",
        Texts.withoutOptions("it is not AEDAT-3; leave out --format"));
  }

  @Test
  void problemsOfFilesAreShownWithoutNamesOfExceptions() {
    IOException full = new IOException("No space left on device");
    assertEquals(
        "No space left on device",
        Texts.oneLine(new CompletionException(new UncheckedIOException(full))));
    assertEquals(
        "cameras.json: there is no such file or folder",
        Texts.oneLine(new NoSuchFileException("cameras.json")));
    assertEquals("IOException", Texts.oneLine(new IOException(" ")));
  }

  @Test
  void labelsOmitTheUnit() {
    assertEquals("Minimum speed", Texts.label("life.minSpeedPxS", "px/s"));
    assertEquals("Hinge", Texts.label("noise.hingePx2PerS", "px^2/s"));
    assertEquals("Body offset x", Texts.label("position.bodyOffsetXPx", "px"));
    assertEquals("Maximum clusters", Texts.label("output.maxClusters", "clusters"));
    assertEquals("Aspect ratio", Texts.label("shape.aspectRatio", "1"));
  }
}
