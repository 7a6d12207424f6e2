package haltere.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The installed program, as a user starts it. */
@Timeout(60)
class StartScriptTest {
  private record Run(int status, String out, String err) {}

  @TempDir Path folder;

  private Path script;

  @BeforeEach
  void findScript() {
    Assumptions.assumeFalse(
        System.getProperty("os.name").startsWith("Windows"), "this is the script for a Unix shell");
    script = Path.of(System.getProperty("haltere.installed"), "bin", "haltere");
  }

  private Run run(Path program, Map<String, String> environment, String... arguments)
      throws Exception {
    List<String> command = new ArrayList<>(List.of(program.toString()));
    command.addAll(List.of(arguments));
    Path out = folder.resolve("stdout.txt");
    Path err = folder.resolve("stderr.txt");
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectOutput(out.toFile())
            .redirectError(err.toFile());
    for (String variable : List.of("DISPLAY", "JAVA_OPTS", "HALTERE_OPTS", "JAVA_TOOL_OPTIONS")) {
      builder.environment().remove(variable);
    }
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.environment().putAll(environment);
    int status = builder.start().waitFor();
    return new Run(status, read(out), read(err));
  }

  private static String read(Path file) throws IOException {
    return Files.readString(file, StandardCharsets.UTF_8);
  }

  @Test
  void scriptStartsThroughASymbolicLinkWithoutMessages() throws Exception {
    Path link = Files.createSymbolicLink(folder.resolve("my haltere"), script);
    Run run = run(link, Map.of(), "--version");
    assertEquals(new Run(0, run.out(), ""), run);
    assertTrue(run.out().matches("haltere \\d+\\.\\d+\\.\\d+\\S*\n"), run.out());
  }

  @Test
  void argumentsWithBlanksAreNotSplit() throws Exception {
    Run run = run(script, Map.of(), "info", "no such * file.aedat");
    assertEquals(new Run(1, "", "haltere: no such * file.aedat: there is no such file\n"), run);
  }

  @Test
  void fileNamesWithUmlautsOpenInTheCLocale() throws Exception {
    String commands =
        "name=$(printf 'Fl\\303\\274gel.csv'); printf 't_us,x,y,on\\n1,2,3,1\\n' > $name;"
            + " \"$HALTERE\" convert $name out-$name && \"$HALTERE\" info out-$name";
    Run run =
        run(
            Path.of("/bin/sh"),
            Map.of("LC_ALL", "C", "HALTERE", script.toString()),
            "-c",
            commands);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("wrote out-Fl\u00fcgel.csv"), run.err());
  }

  @Test
  void additionalJavaOptionsCauseNoWarning() throws Exception {
    for (String options : List.of("-XX:+UseParallelGC", "-Xmx300m -Xss1m", "-Xshare:off")) {
      Run run = run(script, Map.of("JAVA_OPTS", options), "filters", "refractory");
      assertEquals(0, run.status(), run.err());
      assertEquals("", run.err());
      assertTrue(run.out().startsWith("refractory\n"), run.out());
    }
  }

  @Test
  void missingJavaIsReported() throws Exception {
    Run run = run(script, Map.of("JAVA_HOME", "/nowhere"), "--version");
    assertEquals(1, run.status());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("JAVA_HOME"), run.err());
  }

  @Test
  void billOfMaterialsHasTheLicenceOfEachLibrary() throws IOException {
    Path installed = script.getParent().getParent();
    Map<?, ?> bill = (Map<?, ?>) Json.read(installed.resolve("haltere.cdx.json"));
    Set<Object> named = new HashSet<>();
    for (Object component : (List<?>) bill.get("components")) {
      assertFalse(((List<?>) ((Map<?, ?>) component).get("licenses")).isEmpty());
      named.add(((Map<?, ?>) component).get("bom-ref"));
    }
    Set<Object> libraries = new HashSet<>();
    try (Stream<Path> files = Files.walk(installed.resolve("lib"))) {
      files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(".jar") && !name.startsWith("haltere-"))
          .forEach(libraries::add);
    }
    assertEquals(libraries, named);
    assertTrue(read(installed.resolve("THIRD-PARTY.md")).contains("LGPL-2.1"));
    assertTrue(read(installed.resolve("licenses/LGPL-2.1.txt")).contains("LESSER GENERAL PUBLIC"));
  }

  /** This build's JDK, and those that are installed beside it. */
  static List<Path> installedJdks() throws IOException {
    Path own = Path.of(System.getProperty("java.home"));
    try (Stream<Path> beside = Files.list(own.getParent())) {
      return Stream.concat(Stream.of(own), beside.filter(jdk -> version(jdk) > 17).sorted())
          .distinct()
          .toList();
    }
  }

  /** First number of a JDK's version; 0 where there is no JDK. */
  private static int version(Path jdk) {
    try (Stream<String> lines = Files.lines(jdk.resolve("release"))) {
      return lines
          .map(line -> line.replaceFirst("^JAVA_VERSION=\"(\\d+).*", "$1"))
          .filter(number -> number.matches("\\d+"))
          .findFirst()
          .map(Integer::valueOf)
          .orElse(0);
    } catch (IOException none) {
      return 0;
    }
  }

  @ParameterizedTest
  @MethodSource("installedJdks")
  void nativeCodeIsLoadedWithoutWarningOnEachInstalledJdk(Path jdk) throws Exception {
    Map<String, String> environment = Map.of("JAVA_HOME", jdk.toString());
    Files.writeString(folder.resolve("in.csv"), "t_us,x,y,on\n1,2,3,1\n");
    // Zstandard, libusb and the window toolkit
    String[] arguments = "--quiet convert --sensor 8x8 --rows top in.csv out.aedat4".split(" ");
    assertEquals(new Run(0, "", ""), run(script, environment, arguments));
    Run devices = run(script, environment, "devices");
    assertEquals("", devices.err());
    Run view = run(script, environment, "view");
    assertEquals(1, view.err().lines().count(), view.err());
  }

  @Test
  void closedStandardInputIsAnEmptyOne() throws Exception {
    Run run =
        run(
            Path.of("/bin/sh"),
            Map.of("HALTERE", script.toString()),
            "-c",
            "\"$HALTERE\" info - <&-");
    assertEquals(new Run(1, "", "haltere: -: the file is empty; record or copy it again\n"), run);
  }

  @ParameterizedTest
  @ValueSource(strings = {"out.parquet", "out.mcap"})
  void unusableFolderForTemporaryFilesIsReportedWithTheOption(String out) throws Exception {
    Files.writeString(folder.resolve("in.csv"), "t_us,x,y,on\n1,2,3,1\n");
    Run run =
        run(
            script,
            Map.of("JAVA_OPTS", "-Djava.io.tmpdir=/nowhere"),
            ("--quiet convert --sensor 8x8 --rows top in.csv " + out).split(" "));
    assertEquals(1, run.status());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("/nowhere"), run.err());
    assertTrue(run.err().contains("-Djava.io.tmpdir=FOLDER"), run.err());
    assertFalse(Files.exists(folder.resolve(out)));
  }

  @Test
  void devicesWithoutAFolderForTemporaryFilesNameItAsTheCause() throws Exception {
    Run run = run(script, Map.of("JAVA_OPTS", "-Djava.io.tmpdir=/nowhere"), "devices");
    assertEquals(0, run.status());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("temporary"), run.err());
  }

  @Test
  void viewWithoutDisplayIsReportedInOneLine() throws Exception {
    Run run = run(script, Map.of(), "view");
    assertEquals(1, run.status());
    assertEquals(1, run.err().lines().count(), run.err());
  }
}
