package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Each command of the documents runs, in the order of its document and in a folder that has what
 * the document speaks of. A camera is a simulated one, and seconds are short.
 */
class DocumentedCommandsTest {
  private static final Path DOCS = Path.of("..", "docs");
  private static final Pattern COMMAND =
      Pattern.compile("^(?:\\$ )?(?:ui/build/install/haltere/bin/)?(?=haltere )(.+)$");
  private static final Pattern FILE =
      Pattern.compile(".+\\.(aedat4?|csv|json|raw|h5|xml|png|html)|.+/");
  private static final Set<String> FOLDERS = Set.of("pictures", "plots");

  /** What needs more than a folder of files, and is only understood here. */
  private static final List<String> NEEDS_MORE =
      List.of("--biases", "/data/", "DATA.h5", "davis.aedat4");

  private static final Set<String> WRITING =
      Set.of("convert", "simulate", "orient", "wings", "track", "run", "record", "example");

  @TempDir static Path folder;

  @BeforeAll
  static void layOut() throws IOException {
    SensorGeometry dvs128 = new SensorGeometry(128, 128, Origin.BOTTOM);
    EventPacket swing =
        EventPackets.shifted(EventPackets.uniform(dvs128, 3, 20_000, 0, 997), 64_300_579);
    for (String name : List.of("pendulum.aedat", "pendulum.aedat4", "long.aedat", "left.aedat")) {
      write(name, dvs128, swing);
    }
    Files.createDirectories(folder.resolve("recordings"));
    write("recordings/one.aedat", dvs128, swing);
    succeed("simulate fly fly.aedat");
    succeed("simulate road overpass.aedat");
    write("chain.json", json("using.md", "\"filters\""));
    write("road.json", json("road.md", "bridgeHeightM"));
    write(
        "measured.csv",
        "t_s,x_m\n0,0\n0.01,0.001\n0.02,0.003\n0.03,0.002\n0.04,0.001\n"
            + "0.05,0.000\n0.06,0.001\n0.07,0.003\n0.08,0.002\n0.09,0.001\n");
  }

  private static void write(String name, SensorGeometry sensor, EventPacket events)
      throws IOException {
    Path file = folder.resolve(name);
    try (var writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(sensor)).orElseThrow()) {
      writer.write(events);
      writer.finish();
    }
  }

  private static void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  /** The first block of a document that holds a word. */
  private static String json(String document, String word) throws IOException {
    Matcher blocks =
        Pattern.compile("```(?:json)?\\n(\\{.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(DOCS.resolve(document)));
    while (blocks.find()) {
      if (blocks.group(1).contains(word)) {
        return blocks.group(1);
      }
    }
    throw new AssertionError(document + " has no block with " + word);
  }

  @TestFactory
  Stream<DynamicTest> documentedCommandsRun() throws IOException {
    List<DynamicTest> tests = new ArrayList<>();
    List<Path> documents = new ArrayList<>(List.of(DOCS.resolve("../README.md")));
    try (Stream<Path> files = Files.list(DOCS)) {
      files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(documents::add);
    }
    for (Path document : documents) {
      boolean block = false;
      for (String line : Files.readAllLines(document)) {
        Matcher command = COMMAND.matcher(line.strip());
        if (line.strip().startsWith("```")) {
          block = !block;
        } else if (block && command.matches()) {
          tests.add(
              DynamicTest.dynamicTest(
                  document.getFileName() + ": " + line.strip(), () -> run(command.group(1))));
        }
      }
    }
    assertTrue(tests.size() > 30, tests.size() + " commands were found");
    return tests.stream();
  }

  private static void run(String line) {
    byte[] input = new byte[0];
    for (String part : line.replaceFirst("\\s+(#.*|\\\\)$", "").split("\\|")) {
      if (part.strip().startsWith("haltere ")) {
        input = succeed(part.strip().substring("haltere ".length()), input).bytes();
      }
    }
  }

  private static CommandRun succeed(String command) {
    return succeed(command, new byte[0]);
  }

  private static CommandRun succeed(String command, byte[] input) {
    List<String> arguments = new ArrayList<>();
    String quick = command.replaceAll("--duration \\S+", "");
    for (String word : quick.strip().split("\\s+")) {
      arguments.add(place(word));
    }
    if (NEEDS_MORE.stream().anyMatch(command::contains)) {
      arguments.add("--help");
    } else {
      if (!command.equals(quick) || command.matches("simulate .*|.*--device .*")) {
        // images of a rendered scene are dear
        arguments.addAll(List.of("--duration", command.contains("rendered") ? "0.02" : "0.3"));
      }
      if (arguments.get(0).equals("record") && !command.contains("--device")) {
        arguments.addAll(List.of("--device", "simulated:fly"));
      }
      if (WRITING.contains(arguments.get(0)) && !command.contains("convert - ")) {
        arguments.add("--overwrite");
      }
    }
    CommandRun run = CommandRun.on(CommandRun.Machine.BARE.withInput(input), arguments.toArray());
    assertEquals(0, run.status(), command + ": " + run.err());
    return run;
  }

  private static String place(String word) {
    if (word.startsWith("dvs128:")) {
      return "simulated:fly";
    }
    boolean file = FILE.matcher(word).matches() || FOLDERS.contains(word);
    return file && !word.contains("=")
        ? folder.resolve(word.replace("*", "pendulum")).toString()
        : word;
  }
}
