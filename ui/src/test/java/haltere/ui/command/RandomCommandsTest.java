package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.channels.Channels;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * Commands with options and values at random end in time with status 0, 1 or 2, a line that says
 * why, and nothing unfinished. {@code -Dhaltere.commands=FIRST:COUNT} tries other seeds.
 */
class RandomCommandsTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final int MAX_OPTIONS = 5;

  /** They wait for what never comes, or print what is meant for others. */
  private static final Set<String> LEFT_OUT =
      Set.of("--receivers", "--debug", "--help", "--version", "--device", "--extensions");

  private static final List<String> NUMBERS =
      List.of("0", "1", "-1", "7", "0.5", "1e-9", "1e300", "NaN", "9999999999", "x", "");

  /** What would run for long is kept short. */
  private static final List<String> DURATIONS = List.of("0.01", "0.02", "0", "-1", "NaN", "x");

  private static final List<String> FILES =
      List.of(
          "good.aedat",
          "cut.aedat",
          "empty.aedat",
          "chain.json",
          "text.txt",
          "missing.aedat",
          "folder",
          "out.csv",
          "out.parquet",
          "out.aedat4",
          "out.h5",
          "out.npz",
          "out.html",
          "out.json",
          "out",
          "nowhere/out.csv",
          "\u00fcml\u00e4ut.csv");

  private static final List<String> WORDS =
      List.of(
          "fly",
          "refractory",
          "aedat2",
          "csv",
          "evt3",
          "fish",
          "64x48",
          "0x0",
          "seed=3",
          "x=1",
          "=",
          "tcp://127.0.0.1:0",
          "udp://127.0.0.1:9",
          "zmq://127.0.0.1:0",
          "pigeon://a:1",
          "",
          "wing-tracker/beats",
          "top",
          "newest",
          "\u00fc",
          "-",
          "--");

  @TempDir Path folder;

  static LongStream seeds() {
    String[] given = System.getProperty("haltere.commands", "1:30").split(":");
    return LongStream.range(0, Long.parseLong(given[1])).map(i -> Long.parseLong(given[0]) + i);
  }

  @ParameterizedTest
  @MethodSource("seeds")
  void commandWithRandomOptionsEndsWithAStatusAndAReason(long seed) throws IOException {
    writeFiles();
    Set<Path> before = filesHere();
    List<String> arguments = command(new SplittableRandom(seed));
    CommandRun run =
        assertTimeoutPreemptively(
            LIMIT, () -> CommandRun.of(arguments.toArray()), () -> "no end: " + arguments);
    String told = String.join(" ", arguments) + "\nstatus " + run.status() + "\n" + run.err();
    assertTrue(run.status() >= 0 && run.status() <= 2, told);
    assertFalse(run.err().contains("\tat "), told);
    assertFalse(run.err().contains("unexpected failure"), told);
    assertFalse(run.err().contains("fault in the"), told);
    if (run.status() != 0) {
      assertTrue(
          run.errorLines().stream()
              .anyMatch(line -> line.matches("haltere.*: .+") && !line.contains(": warning: ")),
          told);
    }
    try (Stream<Path> left = Files.walk(folder)) {
      assertTrue(left.noneMatch(file -> file.toString().endsWith(".part")), told);
    }
    assertEquals(before, filesHere(), told);
  }

  private static Set<Path> filesHere() throws IOException {
    try (Stream<Path> files = Files.list(Path.of(""))) {
      return files.collect(Collectors.toSet());
    }
  }

  private void writeFiles() throws IOException {
    byte[] good = TinyRecording.hundred().bytes();
    Files.write(folder.resolve("good.aedat"), good);
    Files.write(folder.resolve("cut.aedat"), Arrays.copyOf(good, good.length - 3));
    Files.createFile(folder.resolve("empty.aedat"));
    Files.createDirectory(folder.resolve("folder"));
    Files.writeString(folder.resolve("text.txt"), "a text\n");
    Files.writeString(
        folder.resolve("chain.json"), "{\"filters\": [{\"filter\": \"refractory\"}]}");
  }

  private List<String> command(SplittableRandom random) {
    CommandLine program = new HaltereProgram(nowhere()).commandLine();
    List<String> names = new ArrayList<>(program.getSubcommands().keySet());
    names.remove("bench"); // measures for minutes
    String name = names.get(random.nextInt(names.size()));
    CommandLine.Model.CommandSpec spec = program.getSubcommands().get(name).getCommandSpec();
    List<OptionSpec> options =
        spec.options().stream().filter(option -> !LEFT_OUT.contains(option.longestName())).toList();
    Set<OptionSpec> chosen = new LinkedHashSet<>();
    for (int i = random.nextInt(MAX_OPTIONS + 1); i > 0 && !options.isEmpty(); i--) {
      chosen.add(options.get(random.nextInt(options.size())));
    }
    options.stream()
        .filter(option -> option.required() || option.longestName().equals("--duration"))
        .filter(option -> random.nextInt(8) > 0 || option.longestName().equals("--duration"))
        .forEach(chosen::add);
    List<String> arguments = new ArrayList<>(List.of(name));
    for (OptionSpec option : chosen) {
      arguments.add(
          option.arity().max() == 0
              ? option.longestName()
              : option.longestName() + "=" + value(option, random));
    }
    List<PositionalParamSpec> parameters = spec.positionalParameters();
    for (int i = 0, count = random.nextInt(parameters.size() + 2); i < count; i++) {
      boolean isFile = i >= parameters.size() || isFile(parameters.get(i));
      arguments.add(random.nextInt(4) > 0 ? file(random) : word(isFile, WORDS, random));
    }
    return arguments;
  }

  private static boolean isFile(ArgSpec parameter) {
    return Stream.concat(Stream.of(parameter.type()), Arrays.stream(parameter.auxiliaryTypes()))
        .anyMatch(Path.class::isAssignableFrom);
  }

  /** A word; one that names a file is in the folder, so nothing is written where the tests run. */
  private String word(boolean isFile, List<String> from, SplittableRandom random) {
    String word = pick(from, random);
    boolean isName = isFile && !word.isEmpty() && !word.startsWith("-");
    return isName ? folder.resolve(word).toString() : word;
  }

  private static CommandEnvironment nowhere() {
    PrintStream nobody = new PrintStream(OutputStream.nullOutputStream());
    ReadableByteChannel nothing = Channels.newChannel(InputStream.nullInputStream());
    return new CommandEnvironment(
        nothing, nobody, nobody, false, false, Map.of(), Path.of(""), null);
  }

  private String value(OptionSpec option, SplittableRandom random) {
    if (option.longestName().equals("--duration")) {
      return pick(DURATIONS, random);
    }
    if (option.completionCandidates() != null && random.nextInt(4) > 0) {
      List<String> candidates = new ArrayList<>();
      option.completionCandidates().forEach(candidates::add);
      return candidates.isEmpty() ? "" : pick(candidates, random).toLowerCase(Locale.ROOT);
    }
    boolean number = Number.class.isAssignableFrom(boxed(option.type()));
    boolean isFile = isFile(option);
    return switch (random.nextInt(5)) {
      case 0 -> word(isFile, WORDS, random);
      case 1 -> word(isFile, NUMBERS, random);
      default -> number ? pick(NUMBERS, random) : isFile ? file(random) : pick(WORDS, random);
    };
  }

  private static Class<?> boxed(Class<?> type) {
    return type.isPrimitive() && type != boolean.class ? Number.class : type;
  }

  private String file(SplittableRandom random) {
    return folder.resolve(pick(FILES, random)).toString();
  }

  private static String pick(List<String> from, SplittableRandom random) {
    return from.get(random.nextInt(from.size()));
  }
}
