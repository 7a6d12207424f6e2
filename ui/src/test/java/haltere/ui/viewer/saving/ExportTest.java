package haltere.ui.viewer.saving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.format.ProgressListener;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.playback.Loop;
import haltere.core.playback.Slicing;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.frequency.PixelRegion;
import haltere.testing.StreamRecorder;
import haltere.ui.export.Mp4Writer;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.FontLetters;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.InspectionFeature;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.MeasuredLine;
import haltere.ui.viewer.playback.PlaybackController;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Exports of a marked part, in the real window. */
class ExportTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @BeforeEach
  void open() throws IOException {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.pause();
    viewer.run(() -> viewer.window.context().playback().setSpeed(0.25));
    seek(500_000);
    viewer.run(viewer.window.context().playback()::markIn);
    markOut(620_000);
    assertEquals(OptionalLong.of(500_000), loop().inUs());
  }

  private void markOut(long elapsedUs) {
    seek(elapsedUs);
    viewer.run(viewer.window.context().playback()::markOut);
  }

  private void seek(long elapsedUs) {
    viewer.session().player().seek(elapsedUs).join();
  }

  @AfterEach
  void close() {
    System.clearProperty(Mp4Writer.PROPERTY);
    viewer.close();
  }

  private ExportFeature export() {
    return viewer.window.feature(ExportFeature.class);
  }

  private Loop loop() {
    return viewer.onFx(() -> viewer.window.context().playback().loopProperty().get());
  }

  private String said() {
    return viewer.text("status-message");
  }

  @Test
  void markedPartIsExportedAsAnAnimatedPicture() throws IOException {
    Path file = folder.resolve("part.gif");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("it says so", () -> said().matches("Exported part.gif: 1[23] pictures"));
    ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
    try (ImageInputStream input = ImageIO.createImageInputStream(file.toFile())) {
      reader.setInput(input);
      // 0.12 s and a slice at a quarter of real time and 25 pictures a second
      int pictures = reader.getNumImages(true);
      assertTrue(pictures == 12 || pictures == 13, pictures + " pictures");
      BufferedImage first = reader.read(0);
      BufferedImage last = reader.read(11);
      assertEquals(768, first.getWidth());
      assertTrue(middleX(last) > middleX(first) + 10, "the blob moves to the right");
    } finally {
      reader.dispose();
    }
  }

  /** Middle of what is orange. */
  private static double middleX(BufferedImage image) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        int rgb = image.getRGB(x, y);
        if ((rgb >> 16 & 0xFF) > 150 && (rgb & 0xFF) < 100) {
          sum += x;
          count++;
        }
      }
    }
    return sum / count;
  }

  @Test
  void markedPartIsExportedAsARecordingOfPassedEvents() throws IOException {
    Path file = folder.resolve("part.aedat4");
    viewer.run(() -> export().exportData(file));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.aedat4"));
    RecordingSummary whole = summary(folder.resolve("blob.aedat"));
    RecordingSummary part = summary(file);
    assertTrue(
        part.events() > 100 && part.events() < whole.events() / 5, part.events() + " events");
    assertTrue(part.firstUs() >= whole.firstUs() + loop().inUs().getAsLong());
    assertTrue(part.lastUs() < whole.firstUs() + loop().outUs().getAsLong());
  }

  @Test
  void openRecordingIsNotReplacedByItsPart() throws IOException {
    Path file = folder.resolve("blob.aedat");
    long bytes = Files.size(file);
    viewer.run(() -> export().exportData(file));
    viewer.waitFor("the refusal", () -> said().contains("blob.aedat is open; choose another name"));
    assertEquals(bytes, Files.size(file));
  }

  @Test
  void exportedPartHasTheEventsThatPassThereInTheWholeRecording() throws IOException {
    viewer.addNoiseFilters();
    viewer.run(() -> export().exportData(folder.resolve("part.aedat4")));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.aedat4"));
    Path whole = folder.resolve("blob.aedat");
    long startUs = summary(whole).firstUs();
    EventPacket expected = new EventPacket(0);
    try (RecordingReader reader = Recordings.open(whole);
        FilterChain chain = new FilterChain(reader.geometry())) {
      viewer.session().chain().stages().forEach(stage -> chain.add(Filters.named(stage.kind())));
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              chain.packet(packet);
              int from = packet.indexAtOrAfter(startUs + loop().inUs().getAsLong());
              int to = packet.indexAtOrAfter(startUs + loop().outUs().getAsLong());
              expected.append(packet, from, to);
            }

            @Override
            public void notified(StreamNotification notification) {
              chain.notified(notification);
            }
          });
    }
    StreamRecorder exported = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(folder.resolve("part.aedat4"))) {
      reader.drainTo(exported);
    }
    assertEquals(expected, exported.events());
  }

  private static RecordingSummary summary(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      return RecordingSummary.scan(reader, ProgressListener.NONE);
    }
  }

  @Test
  void exportShowsProgressAndCanBeStopped() {
    // three thousand pictures
    viewer.run(() -> viewer.window.context().playback().setSpeed(0.001));
    Path file = folder.resolve("part.gif");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("it says how far", () -> said().matches("Exporting to part.gif \u2026 \\d+ %"));
    viewer.run(() -> viewer.window.context().actions().run("stop-export"));
    viewer.waitFor("it was stopped", () -> said().equals("Exports were stopped"));
    assertFalse(Files.exists(file));
    viewer.run(() -> export().exportData(folder.resolve("next.aedat4")));
    viewer.waitFor("the next one", () -> said().startsWith("Exported next.aedat4"));
  }

  @Test
  void mp4WithoutFfmpegGivesAdvice() {
    System.setProperty(Mp4Writer.PROPERTY, folder.resolve("none").toString());
    Path file = folder.resolve("part.mp4");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("what to do", () -> said().startsWith("MP4 needs the program ffmpeg"));
    assertFalse(Files.exists(file));
  }

  @Test
  void mp4IsWrittenByTheFoundProgram() throws IOException {
    assumeTrue(File.separatorChar == '/', "the stand-in for ffmpeg is a shell script");
    Path program = folder.resolve("ffmpeg");
    Files.writeString(
        program, "#!/bin/sh\nfor last; do :; done\nwc -c > \"$last\"\necho \"$@\" >> \"$last\"\n");
    assertTrue(program.toFile().setExecutable(true));
    System.setProperty(Mp4Writer.PROPERTY, program.toString());
    Path file = folder.resolve("part.mp4");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.mp4"));
    List<String> lines = Files.readAllLines(file);
    long bytes = Long.parseLong(lines.get(0).strip());
    assertEquals(0, bytes % (768L * 768 * 3), "whole pictures");
    assertTrue(bytes / (768L * 768 * 3) >= 12);
    assertTrue(lines.get(1).contains("-video_size 768x768"), lines.get(1));
    assertFalse(Files.exists(folder.resolve(".part.mp4.part")));
  }

  @Test
  void hangingProgramIsKilledWithTheExport() throws IOException {
    assumeTrue(File.separatorChar == '/', "the stand-in for ffmpeg is a shell script");
    Path number = hangingProgram();
    Path file = folder.resolve("part.mp4");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("it hangs", () -> Files.exists(number));
    viewer.run(() -> viewer.window.context().actions().run("stop-export"));
    viewer.waitFor("it was stopped", () -> said().equals("Exports were stopped"));
    viewer.waitFor("the program is gone", () -> !isAlive(number));
    viewer.run(() -> export().exportData(folder.resolve("next.aedat4")));
    viewer.waitFor("the next one", () -> said().startsWith("Exported next.aedat4"));
    assertFalse(Files.exists(file));
  }

  @Test
  void programThatAcceptsNoPicturesTimesOut() throws IOException {
    assumeTrue(File.separatorChar == '/', "the stand-in for ffmpeg is a shell script");
    Path number = hangingProgram();
    BufferedImage picture = new BufferedImage(640, 480, BufferedImage.TYPE_INT_RGB);
    Path file = folder.resolve("part.mp4");
    try (Mp4Writer film = new Mp4Writer(file, 25, Duration.ofMillis(300))) {
      IOException problem =
          assertThrows(
              IOException.class,
              () -> {
                for (int i = 0; i < 10; i++) {
                  film.add(picture);
                }
              });
      assertTrue(problem.getMessage().startsWith("ffmpeg has accepted no picture"));
    }
    viewer.waitFor("the program is gone", () -> !isAlive(number));
    assertFalse(Files.exists(folder.resolve(".part.mp4.part")));
  }

  /** Makes a program that takes nothing and never ends; the file that its number will be in. */
  private Path hangingProgram() throws IOException {
    Path program = folder.resolve("ffmpeg");
    Path number = folder.resolve("number");
    Files.writeString(
        program,
        "#!/bin/sh\necho $$ > '"
            + number
            + ".new'\nmv '"
            + number
            + ".new' '"
            + number
            + "'\n"
            + "exec sleep 1000\n");
    assertTrue(program.toFile().setExecutable(true));
    System.setProperty(Mp4Writer.PROPERTY, program.toString());
    return number;
  }

  private static boolean isAlive(Path number) {
    try {
      return ProcessHandle.of(Long.parseLong(Files.readString(number).strip()))
          .map(ProcessHandle::isAlive)
          .orElse(false);
    } catch (IOException notYet) {
      return true;
    }
  }

  @Test
  void filmAndPictureContainTapeAndRegion() throws IOException {
    Path bare = folder.resolve("bare.png");
    Path marked = folder.resolve("marked.png");
    savePicture(bare);
    viewer.run(
        () -> {
          viewer.window.feature(InspectionFeature.class).setRegion(Optional.of(REGION));
          viewer.window.context().display().tapeProperty().set(Optional.of(TAPE));
        });
    savePicture(marked);
    markOut(510_000);
    Path film = folder.resolve("part.gif");
    viewer.run(() -> export().exportFilm(film));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.gif"));
    BufferedImage before = ImageIO.read(bare.toFile());
    for (BufferedImage image :
        List.of(ImageIO.read(marked.toFile()), ImageIO.read(film.toFile()))) {
      assertTrue(differs(before, image, 6 * 20, 6 * (127 - 100)), "the tape");
      assertTrue(differs(before, image, 6 * 90 - 3, 6 * (127 - 15)), "the region's left edge");
      assertFalse(differs(before, image, 6 * 60, 6 * (127 - 110)), "nothing elsewhere");
    }
  }

  @Test
  void filmOfASceneBeginsWithTheMarksOfItsTracker() throws IOException {
    PlaybackController playback = viewer.window.context().playback();
    viewer.run(() -> viewer.window.context().actions().run("open-scene"));
    viewer.waitUntilOpen("Fly scene");
    viewer.waitFor("wings", () -> playback.speedProperty().get() < 0.1);
    viewer.run(() -> playback.setSpeed(1));
    viewer.waitFor("some beats", () -> viewer.status().elapsedUs() > 700_000);
    viewer.pause();
    viewer.run(() -> playback.setSpeed(0.1));
    seek(600_000);
    viewer.run(playback::markIn);
    markOut(605_000);
    Path film = folder.resolve("scene.gif");
    viewer.run(() -> export().exportFilm(film));
    viewer.waitFor("it says so", () -> said().startsWith("Exported scene.gif"));
    BufferedImage first = ImageIO.read(film.toFile());
    int pink = 0;
    for (int i = 0; i < first.getWidth() * first.getHeight(); i++) {
      int rgb = first.getRGB(i % first.getWidth(), i / first.getWidth());
      pink += (rgb >> 16 & 0xFF) > 200 && (rgb & 0xFF) > 170 && (rgb >> 8 & 0xFF) < 180 ? 1 : 0;
    }
    assertTrue(pink > 50, pink + " pixels of the left wing");
  }

  private static final PixelRegion REGION = PixelRegion.between(90, 10, 110, 20);
  private static final MeasuredLine TAPE = new MeasuredLine(10, 100, 40, 100);

  private void savePicture(Path file) {
    viewer.run(() -> viewer.window.feature(SavingFeature.class).savePicture(file));
    viewer.waitFor("the picture", () -> Files.exists(file));
  }

  /** Whether two pictures differ clearly within three pixels of a place. */
  private static boolean differs(BufferedImage one, BufferedImage other, int x, int y) {
    for (int dy = -3; dy <= 3; dy++) {
      for (int dx = -3; dx <= 3; dx++) {
        int a = one.getRGB(x + dx, y + dy);
        int b = other.getRGB(x + dx, y + dy);
        for (int shift = 0; shift <= 16; shift += 8) {
          if (Math.abs((a >> shift & 0xFF) - (b >> shift & 0xFF)) > 60) {
            return true;
          }
        }
      }
    }
    return false;
  }

  @Test
  void filmFadesAsThePictureOnTheScreenDoes() throws IOException {
    DisplayControl display = viewer.window.context().display();
    viewer.run(() -> display.modeProperty().set(DisplayMode.COUNTS));
    Path following = folder.resolve("following.gif");
    viewer.run(() -> export().exportFilm(following));
    viewer.waitFor("it says so", () -> said().startsWith("Exported following.gif"));
    long fadingUs = Math.round(2.5 * viewer.status().sliceUs());
    viewer.run(() -> display.decayUsProperty().set(fadingUs));
    Path fixed = folder.resolve("fixed.gif");
    viewer.run(() -> export().exportFilm(fixed));
    viewer.waitFor("it says so", () -> said().startsWith("Exported fixed.gif"));
    assertEquals(-1, Files.mismatch(following, fixed));
  }

  @Test
  void filmOfLongSlicesShowsAllOfEachSlice() throws IOException {
    DisplayControl display = viewer.window.context().display();
    PlaybackController playback = viewer.window.context().playback();
    viewer.run(
        () -> {
          display.modeProperty().set(DisplayMode.COUNTS);
          display.decayUsProperty().set(DisplayOptions.SLICE_ONLY);
          playback.setSpeed(1);
        });
    viewer.session().player().setSlicing(new Slicing.ByTime(100_000)).join();
    seek(500_000);
    viewer.run(playback::markIn);
    markOut(700_000);
    Path film = folder.resolve("slices.gif");
    viewer.run(() -> export().exportFilm(film));
    viewer.waitFor("it says so", () -> said().equals("Exported slices.gif: 3 pictures"));
    seek(500_000);
    Path picture = folder.resolve("slice.png");
    savePicture(picture);
    assertTrue(isLike(ImageIO.read(picture.toFile()), ImageIO.read(film.toFile())));
  }

  /** Whether the middles of two pictures are the same, but for the palette of a film. */
  private static boolean isLike(BufferedImage one, BufferedImage other) {
    for (int y = 60; y < one.getHeight() - 60; y++) {
      for (int x = 0; x < one.getWidth(); x++) {
        Color a = new Color(one.getRGB(x, y));
        Color b = new Color(other.getRGB(x, y));
        if (Math.abs(a.getRed() - b.getRed()) + Math.abs(a.getBlue() - b.getBlue()) > 20) {
          return false;
        }
      }
    }
    return true;
  }

  @Test
  void windowThatIsClosedDuringAnExportLeavesNoPartOfTheFilm() throws IOException {
    viewer.run(() -> viewer.window.context().playback().setSpeed(0.001));
    viewer.run(() -> export().exportFilm(folder.resolve("closed.gif")));
    viewer.waitFor("a part of the film", () -> !filmsHere().isEmpty());
    viewer.run(viewer.stage::hide);
    assertEquals(List.of(), filmsHere());
  }

  private List<String> filmsHere() {
    String[] names = folder.toFile().list((place, name) -> name.contains("closed.gif"));
    return List.of(names);
  }

  @Test
  void filmOfTheLastSliceShowsWhatTheScreenShows() throws IOException {
    DisplayControl display = viewer.window.context().display();
    viewer.run(() -> display.decayUsProperty().set(DisplayOptions.SLICE_ONLY));
    for (DisplayMode mode : List.of(DisplayMode.POLARITY, DisplayMode.COUNTS)) {
      viewer.run(() -> display.modeProperty().set(mode));
      Path film = folder.resolve(mode + ".gif");
      viewer.run(() -> export().exportFilm(film));
      viewer.waitFor("it says so", () -> said().startsWith("Exported " + mode + ".gif"));
      // its first picture ends 0.04 s after the start, at a quarter of real time
      seek(510_000 - viewer.status().sliceUs());
      Path picture = folder.resolve(mode + ".png");
      savePicture(picture);
      BufferedImage onScreen = ImageIO.read(picture.toFile());
      BufferedImage inFilm = ImageIO.read(film.toFile());
      int different = 0;
      for (int i = 3; i < 765; i += 3) {
        for (int j = 60; j < 700; j += 3) {
          different += differs(onScreen, inFilm, i, j) ? 1 : 0;
        }
      }
      assertEquals(0, different, "places that differ");
      seek(620_000);
    }
  }

  @Test
  void filmsAndPicturesContainTheColourLegend() throws IOException {
    viewer.run(
        () -> viewer.window.context().display().modeProperty().set(DisplayMode.TIME_SURFACE));
    Path picture = folder.resolve("picture.png");
    savePicture(picture);
    assertEquals(Gradient.CIVIDIS.colour(1), lastOfScale(ImageIO.read(picture.toFile())));
    markOut(510_000);
    Path film = folder.resolve("part.gif");
    viewer.run(() -> export().exportFilm(film));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.gif"));
    int seen = lastOfScale(ImageIO.read(film.toFile()));
    assertTrue((seen >> 16 & 0xFF) > 230 && (seen & 0xFF) < 100, Integer.toHexString(seen));
  }

  /** The last colour of the strip in the lower right corner, before the word "now". */
  private static int lastOfScale(BufferedImage image) {
    int word = (int) FontLetters.OF_PICTURES.width("now");
    return image.getRGB(image.getWidth() - 1 - 6 - 6 - word - 6, image.getHeight() - 6 - 6 - 7);
  }

  @Test
  void earlierProblemDoesNotHideAnExport() {
    viewer.run(
        () ->
            viewer
                .window
                .context()
                .sessions()
                .open(folder.resolve("missing.aedat"), ReadOptions.DEFAULT));
    viewer.waitFor("a problem", () -> said().contains("there is no such file"));
    viewer.run(() -> export().exportData(folder.resolve("part.aedat4")));
    viewer.waitFor("it says so", () -> said().startsWith("Exported part.aedat4"));
  }

  @Test
  void exportOfAClosedRecordingStatesIt() {
    viewer.session().player().close();
    viewer.run(() -> export().exportData(folder.resolve("part.aedat4")));
    viewer.waitFor("it says so", () -> said().startsWith("part.aedat4 was not exported"));
  }

  @Test
  void mp4OfTheBlobIsReadableByFfmpeg() throws Exception {
    Optional<Path> program = Mp4Writer.findProgram();
    assumeTrue(program.isPresent(), "ffmpeg is not on this machine");
    Path file = folder.resolve("part.mp4");
    viewer.run(() -> export().exportFilm(file));
    viewer.waitFor("it says so", () -> said().matches("Exported part.mp4: 1[23] pictures"));
    Path decoded = folder.resolve("decoded.rgb");
    Process decoding =
        new ProcessBuilder(
                program.get().toString(),
                "-v",
                "error",
                "-i",
                file.toString(),
                "-f",
                "rawvideo",
                "-pix_fmt",
                "rgb24",
                decoded.toString())
            .inheritIO()
            .start();
    assertEquals(0, decoding.waitFor());
    byte[] pixels = Files.readAllBytes(decoded);
    int side = 768;
    assertEquals(0, pixels.length % (side * side * 3));
    assertTrue(pixels.length / (side * side * 3) >= 12);
    BufferedImage first = picture(pixels, 0, side);
    BufferedImage last = picture(pixels, 11, side);
    assertTrue(middleX(last) > middleX(first) + 10, "the blob moves to the right");
  }

  private static BufferedImage picture(byte[] rgb, int number, int side) {
    BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_RGB);
    int at = number * side * side * 3;
    for (int i = 0; i < side * side; i++, at += 3) {
      image.setRGB(
          i % side,
          i / side,
          (rgb[at] & 0xFF) << 16 | (rgb[at + 1] & 0xFF) << 8 | rgb[at + 2] & 0xFF);
    }
    return image;
  }

  @Test
  void markIsNamedAndATimeIsEnteredToSeek() {
    viewer.run(() -> viewer.window.context().actions().run("name-mark"));
    viewer.waitFor("the question", () -> viewer.isThere("answer"));
    TextField answer = viewer.node("answer", TextField.class);
    viewer.run(() -> answer.setText("take-off"));
    viewer.waitFor("focus", answer::isFocused);
    viewer.press(KeyCode.ENTER);
    viewer.waitFor(
        "the mark",
        () ->
            viewer.window.context().playback().marks().stream()
                .anyMatch(mark -> mark.name().equals("take-off")));
    viewer.run(() -> viewer.window.context().actions().run("jump-to-time"));
    viewer.waitFor("the question", () -> viewer.isThere("answer"));
    TextField time = viewer.node("answer", TextField.class);
    viewer.run(() -> time.setText("1250 ms"));
    viewer.waitFor("focus", time::isFocused);
    viewer.press(KeyCode.ENTER);
    viewer.waitFor("there", () -> viewer.status().elapsedUs() == 1_250_000);
  }
}
