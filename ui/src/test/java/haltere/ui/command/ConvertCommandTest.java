package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConvertCommandTest {
  @TempDir Path folder;

  private Path in;
  private Path out;
  private Locale locale;

  @BeforeEach
  void writeRecording() throws IOException {
    locale = Locale.getDefault();
    in = TinyRecording.hundred().write(folder.resolve("hundred.aedat"));
    out = folder.resolve("out.csv");
  }

  @AfterEach
  void restoreLocale() {
    Locale.setDefault(locale);
  }

  private List<String> converted(Object... arguments) throws IOException {
    CommandRun run =
        CommandRun.of(Stream.concat(Stream.of("convert", in, out), Stream.of(arguments)).toArray());
    assertEquals(0, run.status(), run.err());
    assertEquals("", run.out());
    List<String> lines = Files.readAllLines(out);
    Files.delete(out);
    return lines;
  }

  @Test
  void csvHasTheDocumentedColumnsAndTheTimesOfTheRecording() throws IOException {
    Locale.setDefault(Locale.forLanguageTag("ar-EG"));
    List<String> lines = converted();
    assertEquals(101, lines.size());
    assertEquals(List.of("t_us,x,y,on", "5000000,0,0,0", "5001000,1,1,1"), lines.subList(0, 3));
    assertEquals("5099000,99,99,0", lines.get(100));
  }

  @Test
  void textWithBottomOriginIsReadBackUnchanged() throws IOException {
    Path text = folder.resolve("bottom.csv");
    assertEquals(0, CommandRun.of("convert", in, text).status());
    Path back = folder.resolve("back.aedat");
    CommandRun run =
        CommandRun.of("convert", text, back, "--rows", "bottom", "--sensor", "128x128");
    assertEquals(0, run.status(), run.err());
    assertEquals("", run.err().replaceFirst("wrote .*\n", ""));
    assertEquals(Files.readAllLines(text), converted(back));
    Path mirrored = folder.resolve("mirrored.aedat");
    CommandRun silent = CommandRun.of("convert", text, mirrored, "--sensor", "128x128");
    assertTrue(silent.err().contains("--rows bottom changes that"), silent.err());
    assertEquals("5000000,0,127,0", converted(mirrored).get(1));
  }

  private List<String> converted(Path recording) throws IOException {
    Path table = folder.resolve("read-back.csv");
    CommandRun run = CommandRun.of("convert", recording, table, "--overwrite");
    assertEquals(0, run.status(), run.err());
    return Files.readAllLines(table);
  }

  @Test
  void timeRangeIsHalfOpen() throws IOException {
    List<String> lines = converted("--from", 5_010_000, "--to", 5_020_000);
    assertEquals(11, lines.size());
    assertEquals("5010000,10,10,1", lines.get(1));
    assertEquals("5019000,19,19,1", lines.get(10));
    assertEquals(90 + 1, converted("--from", 5_010_000).size());
    assertEquals(20 + 1, converted("--to", 5_020_000).size());
  }

  @Test
  void rangeWithoutEventsGivesAnEmptyTableAndAWarning() throws IOException {
    CommandRun run = CommandRun.of("convert", in, out, "--from", 1, "--to", 2);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("no events in this part"), run.err());
    assertEquals("t_us,x,y,on\n", Files.readString(out));
  }

  @Test
  void lossesOfTheWrittenFormatNameTheWrittenFile() throws IOException {
    Path late = folder.resolve("late.csv");
    Files.writeString(late, "t_us,x,y,on\n1700000000000000,1,2,1\n");
    Path written = folder.resolve("late.es");
    CommandRun run = CommandRun.of("convert", late, written, "--sensor", "8x8");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("warning: " + written + ": the format's clock"), run.err());
  }

  @Test
  void endingOfATableMayHaveCapitals() throws IOException {
    Path small = folder.resolve("small.csv");
    Files.writeString(small, "t_us,x,y,on\n5,1,2,1\n");
    Path table = folder.resolve("EVENTS.PARQUET");
    CommandRun run = CommandRun.of("convert", small, table, "--sensor", "8x8");
    assertEquals(0, run.status(), run.err());
    assertTrue(Files.exists(table));
  }

  @Test
  void originTopFlipsRows() throws IOException {
    assertEquals("5001000,1,126,1", converted("--origin", "top").get(2));
    assertEquals("5001000,1,1,1", converted("--origin", "bottom").get(2));
  }

  @Test
  void originIsRejectedForFormatsWithAFixedOrigin() {
    Path copy = folder.resolve("copy.aedat4");
    CommandRun run = CommandRun.of("convert", in, copy, "--origin", "top");
    assertEquals(2, run.status(), run.err());
    assertTrue(run.err().startsWith("haltere convert: --origin is for plain"), run.err());
    assertEquals(0, CommandRun.of("convert", in, copy).status());
  }

  @Test
  void textWithBottomOriginIsWrittenWithAWarning() {
    String err = CommandRun.of("convert", in, out).err();
    assertTrue(err.contains("warning") && err.contains("--origin top"), err);
  }

  @Test
  void eventsSurviveAConversionAndBack() throws IOException {
    List<String> direct = converted();
    Path copy = folder.resolve("copy.aedat");
    assertEquals(0, CommandRun.of("convert", in, copy).status());
    CommandRun again = CommandRun.of("convert", copy, out);
    assertEquals(0, again.status(), again.err());
    assertEquals(direct, Files.readAllLines(out));
  }

  @Test
  void filtersRunInTheGivenOrder() throws IOException {
    Path noisy = folder.resolve("noisy.aedat");
    TinyRecording events = new TinyRecording();
    for (int i = 0; i < 10; i++) {
      events.event(10 * i, 20, 20, true);
    }
    events.write(noisy);
    in = noisy;
    assertEquals(2, converted("--filter", "refractory").size());
    assertEquals(1, converted("--filter", "refractory", "--filter", "background-activity").size());
  }

  @ParameterizedTest
  @CsvSource({"2, evt2", "2.1, evt21", "3, evt3", ", evt3"})
  void rawFilesHaveTheRequestedEncoding(String encoding, String format) throws IOException {
    List<String> direct = converted("--origin", "top");
    Path raw = folder.resolve("hundred.raw");
    CommandRun made =
        encoding == null
            ? CommandRun.of("convert", in, raw)
            : CommandRun.of("convert", in, raw, "--evt", encoding);
    assertEquals(0, made.status(), made.err());
    try (RecordingReader reader = Recordings.open(raw)) {
      assertEquals(format, reader.formatName());
    }
    in = raw;
    assertEquals(direct, converted());
  }

  @Test
  void encodingIsRejectedForOtherThanRawFiles() throws IOException {
    for (Object[] label :
        new Object[][] {
          {"convert", in, out, "--evt", "2"},
          {"convert", in, folder.resolve("a.raw"), "--evt", "4"},
          {"convert", in, folder.resolve("a.raw"), "--evt", "2", "--stream", "frames"}
        }) {
      CommandRun run = CommandRun.of(label);
      assertEquals(2, run.status(), run.err());
      assertTrue(run.errorLines().get(0).startsWith("haltere convert: --evt is "), run.err());
    }
    try (Stream<Path> files = Files.list(folder)) {
      assertArrayEquals(new Path[] {in}, files.toArray());
    }
  }

  @Test
  void messageReportsTheOutputUnlessQuiet() {
    assertEquals(
        "wrote " + out + " (100 events)\n",
        CommandRun.of("convert", "--origin", "bottom", in, out).err());
    assertEquals(
        "",
        CommandRun.of("convert", "--quiet", "--origin", "bottom", "--overwrite", in, out).err());
  }

  @Test
  void interruptedConversionLeavesNoFile() throws IOException {
    Thread.currentThread().interrupt();
    CommandRun run = CommandRun.of("convert", in, out);
    assertTrue(Thread.interrupted());
    assertEquals(1, run.status());
    assertTrue(run.err().contains("interrupted"), run.err());
    try (Stream<Path> files = Files.list(folder)) {
      assertArrayEquals(new Path[] {in}, files.toArray());
    }
  }
}
