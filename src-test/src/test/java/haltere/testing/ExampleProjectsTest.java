package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The examples are projects of their own: one Gradle process builds all of them, in a folder
 * outside of this checkout, from what its modules publish into a Maven repository.
 */
@Tag("examples")
class ExampleProjectsTest {
  private static final Path CHECKOUT = Path.of("..").toAbsolutePath().normalize();
  private static final int LONGEST_BUILD_MINUTES = 10;

  @TempDir static Path folder;

  @BeforeAll
  static void buildAllFromPublishedArtifacts() throws Exception {
    copy("examples/extension");
    copy("examples/imagej");
    copy("src-test/recordings");
    writeReadmeProject(folder.resolve("examples/readme"));
    Files.writeString(
        folder.resolve("settings.gradle"),
        """
        ['extension', 'imagej', 'readme'].each { includeBuild "examples/$it" }
        """);
    Files.writeString(
        folder.resolve("build.gradle"),
        """
        tasks.register('examples') {
            dependsOn gradle.includedBuild('extension').task(':build')
            dependsOn gradle.includedBuild('imagej').task(':build')
            dependsOn gradle.includedBuild('readme').task(':run')
        }
        """);
    List<String> command =
        new ArrayList<>(List.of(CHECKOUT.resolve("gradlew").toString(), "-p", folder.toString()));
    command.add("-Dorg.gradle.project.haltere.repository=" + CHECKOUT.resolve("build/repository"));
    command.addAll(List.of("--no-daemon", "--console=plain", "examples"));
    if (Boolean.getBoolean("haltere.offline")) {
      command.add("--offline");
    }
    run(command, folder.resolve("gradle.log"));
  }

  private static void copy(String path) throws IOException {
    Path from = CHECKOUT.resolve(path);
    try (Stream<Path> all = Files.walk(from)) {
      for (Path file : (Iterable<Path>) all.filter(Files::isRegularFile)::iterator) {
        Path relative = CHECKOUT.relativize(file);
        if (!from.relativize(file).toString().matches("(build|[.]gradle)/.*")) {
          Files.createDirectories(folder.resolve(relative).getParent());
          Files.copy(file, folder.resolve(relative));
        }
      }
    }
  }

  /** A project of the lines of the README and the coordinates of docs/embedding.md. */
  private static void writeReadmeProject(Path project) throws IOException {
    Path sources = Files.createDirectories(project.resolve("src/main/java"));
    Files.writeString(
        sources.resolve("Example.java"), ReadmeExampleTest.program(ReadmeExampleTest.example()));
    Files.writeString(project.resolve("settings.gradle"), "rootProject.name = 'readme'\n");
    Matcher coordinates =
        Pattern.compile("```groovy\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(CHECKOUT.resolve("docs/embedding.md")));
    assertTrue(coordinates.find());
    Files.writeString(
        project.resolve("build.gradle"),
        """
        plugins { id 'application' }
        repositories {
            maven { url = providers.gradleProperty('haltere.repository').get() }
            mavenCentral()
        }
        java.sourceCompatibility = JavaVersion.VERSION_17
        application { mainClass = 'Example' }
        dependencies {
        %s}
        """
            .formatted(coordinates.group(1)));
    ReadmeExampleTest.writeMovingSpot(project.resolve("recording.aedat"));
  }

  /** Runs a program; its output stands in a file. */
  private static void run(List<String> command, Path log) throws Exception {
    Process process =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(log.toFile()).start();
    try {
      assertTrue(
          process.waitFor(LONGEST_BUILD_MINUTES, TimeUnit.MINUTES), () -> "too slow" + text(log));
      assertEquals(0, process.exitValue(), () -> text(log));
    } finally {
      process.descendants().forEach(ProcessHandle::destroy);
      process.destroy();
    }
  }

  private static String text(Path file) {
    try {
      return "\n" + Files.readString(file);
    } catch (IOException problem) {
      return problem.toString();
    }
  }

  @Test
  void theLinesOfTheReadmeFollowAMovingSpot() {
    long tracks =
        text(folder.resolve("gradle.log"))
            .lines()
            .filter(line -> line.startsWith("ObjectTrack["))
            .count();
    assertTrue(tracks > 5, () -> text(folder.resolve("gradle.log")));
  }

  @Test
  void theExtensionKeepsTheContractOfFiltersAndIsFoundByTheProgram() throws Exception {
    assertTrue(tests("extension") > 5);
    Path jars = folder.resolve("examples/extension/build/libs");
    Path program = Path.of(System.getProperty("haltere.installed"), "bin", "haltere");
    Path log = folder.resolve("filters.log");
    run(List.of(program.toString(), "filters", "--extensions", jars.toString()), log);
    assertTrue(text(log).contains("decimate"), () -> text(log));
  }

  @Test
  void thePluginWorksInImageJ() throws IOException {
    assertTrue(tests("imagej") > 5);
  }

  /** Tests of an example that ran; the build fails where one of them does. */
  private static int tests(String example) throws IOException {
    int tests = 0;
    try (Stream<Path> reports =
        Files.list(
            folder.resolve("examples").resolve(example).resolve("build/test-results/test"))) {
      for (Path report : (Iterable<Path>) reports.filter(Files::isRegularFile)::iterator) {
        Matcher suite =
            Pattern.compile("<testsuite .*tests=\"(\\d+)\" skipped=\"0\"").matcher(text(report));
        tests += suite.find() ? Integer.parseInt(suite.group(1)) : 0;
      }
    }
    return tests;
  }
}
