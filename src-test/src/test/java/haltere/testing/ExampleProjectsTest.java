package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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
    copy("examples/spark");
    copy("src-test/recordings");
    writeReadmeProject(folder.resolve("examples/readme"));
    writeKotlinProject(folder.resolve("examples/kotlin"));
    Files.writeString(
        folder.resolve("settings.gradle"),
        """
        ['extension', 'imagej', 'spark', 'readme', 'kotlin'].each { includeBuild "examples/$it" }
        """);
    Files.writeString(
        folder.resolve("build.gradle"),
        """
        tasks.register('examples') {
            ['extension', 'imagej', 'spark'].each { dependsOn gradle.includedBuild(it).task(':build') }
            ['readme', 'kotlin'].each { dependsOn gradle.includedBuild(it).task(':run') }
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

  /** A project of the lines of the README, with the Java of docs/embedding.md beside it. */
  private static void writeReadmeProject(Path project) throws IOException {
    Path sources = Files.createDirectories(project.resolve("src/main/java"));
    Files.writeString(
        sources.resolve("Example.java"), ReadmeExampleTest.program(ReadmeExampleTest.example()));
    List<String> blocks = embedding("```java\n(?!module)(.*?)```");
    assertEquals(2, blocks.size(), blocks::toString);
    Files.writeString(
        sources.resolve("Embedding.java"),
        """
        import haltere.core.chain.*;
        import haltere.core.event.*;
        import haltere.core.format.*;
        import haltere.core.pipeline.*;
        import haltere.core.sink.*;
        import haltere.core.stream.*;
        import haltere.filters.*;
        import haltere.filters.object.*;
        import java.io.*;
        import java.nio.file.*;

        abstract class Embedding {
          interface Camera {
            boolean read(EventPacket packet);
          }

          abstract void steer(ObjectTrack track);

          void recording() throws IOException {
        %s  }

          void ownEvents(Camera camera) {
        %s  }
        }
        """
            .formatted(blocks.toArray()));
    writeProject(project, "Example", "");
  }

  /** A project of the Kotlin of docs/embedding.md: imports, and statements as the body of main. */
  private static void writeKotlinProject(Path project) throws IOException {
    Path source = project.resolve("src/main/kotlin/Example.kt");
    Files.createDirectories(source.getParent());
    String lines = embedding("```kotlin\n(.*?)```").get(0);
    int end = lines.lastIndexOf("import ");
    int body = lines.indexOf('\n', end) + 1;
    Files.writeString(
        source, lines.substring(0, body) + "fun main() {\n" + lines.substring(body) + "}\n");
    writeProject(
        project,
        "ExampleKt",
        """
        def kotlin = '2.1.21'
        configurations { compiler }
        dependencies {
            compiler "org.jetbrains.kotlin:kotlin-compiler-embeddable:$kotlin"
            implementation "org.jetbrains.kotlin:kotlin-stdlib:$kotlin"
        }
        def compiled = file('build/kotlin')
        tasks.register('kotlin', JavaExec) {
            classpath = configurations.compiler
            mainClass = 'org.jetbrains.kotlin.cli.jvm.K2JVMCompiler'
            args '-no-stdlib', '-no-reflect', '-jvm-target', '17', '-d', compiled, file('src/main/kotlin')
            def libraries = configurations.runtimeClasspath
            argumentProviders.add({ ['-classpath', libraries.asPath] } as CommandLineArgumentProvider)
        }
        run {
            dependsOn 'kotlin'
            classpath += files(compiled)
        }
        """);
  }

  /** Matches of an expression in docs/embedding.md. */
  private static List<String> embedding(String expression) throws IOException {
    List<String> found =
        Pattern.compile(expression, Pattern.DOTALL)
            .matcher(Files.readString(CHECKOUT.resolve("docs/embedding.md")))
            .results()
            .map(match -> match.group(1))
            .toList();
    assertFalse(found.isEmpty(), expression);
    return found;
  }

  /** A program with the coordinates of docs/embedding.md, beside the recording of a moving spot. */
  private static void writeProject(Path project, String mainClass, String more) throws IOException {
    Files.writeString(
        project.resolve("settings.gradle"),
        "rootProject.name = '%s'\n".formatted(project.getFileName()));
    Files.writeString(
        project.resolve("build.gradle"),
        """
        plugins { id 'application' }
        repositories {
            maven { url = providers.gradleProperty('haltere.repository').get() }
            mavenCentral()
        }
        java.sourceCompatibility = JavaVersion.VERSION_17
        application { mainClass = '%s' }
        dependencies {
        %s}
        """
                .formatted(mainClass, embedding("```groovy\n(.*?)```").get(0))
            + more);
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
  void readmeExampleTracksAMovingSpotInJavaAndKotlin() {
    String log = text(folder.resolve("gradle.log"));
    for (String project : List.of("readme", "kotlin")) {
      String task = ":" + project + ":run\n";
      List<String> printed =
          Stream.of(log.split("(?m)^> Task ")).filter(part -> part.startsWith(task)).toList();
      assertFalse(printed.isEmpty(), log);
      // Gradle repeats the name of a task where it continues with its output
      assertTracks(String.join("\n", printed));
    }
  }

  private static void assertTracks(String printed) {
    assertTrue(printed.lines().filter(line -> line.contains("ObjectTrack[")).count() > 5, printed);
  }

  @Test
  void readmeExampleRunsInJShell() throws Exception {
    Path project = folder.resolve("examples/readme");
    Path installed = project.resolve("ui/build/install/haltere");
    Files.createDirectories(installed.getParent());
    Files.createSymbolicLink(installed, Path.of(System.getProperty("haltere.installed")));
    Files.writeString(project.resolve("lines.jsh"), ReadmeExampleTest.example());
    String shell = embedding("`(jshell [^`]*)`").get(0);
    Path log = folder.resolve("jshell.log");
    run(List.of("bash", "-c", "cd '%s' && exec %s -s - <lines.jsh".formatted(project, shell)), log);
    assertTracks(text(log));
  }

  @Test
  void extensionExampleMeetsTheFilterContractAndIsLoadedByTheProgram() throws Exception {
    assertTrue(tests("extension") > 5);
    Path jars = folder.resolve("examples/extension/build/libs");
    Path program = Path.of(System.getProperty("haltere.installed"), "bin", "haltere");
    Path log = folder.resolve("filters.log");
    run(List.of(program.toString(), "filters", "--extensions", jars.toString()), log);
    assertTrue(text(log).contains("decimate"), () -> text(log));
  }

  @Test
  void imageJPluginTestsPass() throws IOException {
    assertTrue(tests("imagej") > 5);
  }

  @Test
  void sparkExampleCountsTheObjectsOfRecordings() throws IOException {
    assertEquals(1, tests("spark"));
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
