package haltere.testing.embedding;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A modular program with core and filters on its module path (decision 4). */
class ModulePathTest {
  private static final String MAIN =
      """
      package app;

      import haltere.core.chain.ChainFile;
      import haltere.core.chain.FilterChain;
      import haltere.core.chain.Filters;
      import haltere.core.event.SensorGeometry;
      import haltere.core.format.Recordings;

      public class Main {
        public static void main(String[] args) {
          FilterChain chain = new FilterChain(new SensorGeometry(64, 64));
          chain.add(Filters.named("wing-tracker"));
          System.out.println(FilterChain.class.getModule().getName());
          System.out.println(Recordings.formats().containsKey("aedat4"));
          System.out.println(ChainFile.write(chain).contains("wing-tracker"));
        }
      }
      """;

  @TempDir Path folder;

  @Test
  void moduleThatRequiresJacksonWritesJsonWithoutAFlag() throws Exception {
    String jars =
        Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .filter(
                path ->
                    path.matches(
                        ".*/(haltere-(core|filters)|jackson-core|lz4-java|zstd-jni|ejml-|commons-)[^/]*jar"))
            .collect(Collectors.joining(File.pathSeparator));
    assertTrue(jars.contains("haltere-core"), jars);
    Files.createDirectories(folder.resolve("app"));
    Files.writeString(folder.resolve("app/Main.java"), MAIN);
    Files.writeString(
        folder.resolve("module-info.java"),
        "module app { requires haltere.core; requires haltere.filters;"
            + " requires com.fasterxml.jackson.core; }");
    Path classes = folder.resolve("classes");
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-p",
                jars,
                "-d",
                classes.toString(),
                folder.resolve("module-info.java").toString(),
                folder.resolve("app/Main.java").toString());
    assertEquals(0, status);
    assertEquals(
        List.of("haltere.core", "true", "true"),
        run("-p", jars + File.pathSeparator + classes, "-m", "app/app.Main"));
  }

  private static List<String> run(String... args) throws IOException, InterruptedException {
    Path java = Path.of(System.getProperty("java.home"), "bin", "java");
    Process process =
        new ProcessBuilder(Stream.concat(Stream.of(java.toString()), Stream.of(args)).toList())
            .redirectErrorStream(true)
            .start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(1, TimeUnit.MINUTES));
    assertEquals(0, process.exitValue(), text);
    return text.lines().toList();
  }
}
