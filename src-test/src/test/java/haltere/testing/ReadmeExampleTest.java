package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.StringWriter;
import java.lang.reflect.Method;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example of the README compiles and works. */
class ReadmeExampleTest {
  private static final Path README = Path.of("..", "README.md");
  private static final Pattern EXAMPLE = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL);

  @TempDir Path folder;

  @Test
  void readmeExampleCompilesAndTracksAMovingSpot() throws Exception {
    String example = example();
    assertTrue(example.lines().filter(line -> !line.startsWith("import ")).count() <= 12, example);
    Path recording = folder.resolve("recording.aedat");
    writeMovingSpot(recording);
    assertTrue(example.contains("\"recording.aedat\""), example);
    String printed =
        run(
            example.replace(
                "\"recording.aedat\"", "\"" + recording.toString().replace("\\", "\\\\") + "\""));
    List<String> lines = printed.lines().toList();
    assertTrue(lines.size() > 5, printed);
    assertTrue(lines.stream().allMatch(line -> line.contains("ObjectTrack[")), printed);
  }

  /** The imports and statements of the README. */
  static String example() throws IOException {
    Matcher block = EXAMPLE.matcher(Files.readString(README));
    assertTrue(block.find(), "there is no Java in " + README);
    return block.group(1);
  }

  /** Imports, and statements as the body of a main method. */
  static String program(String example) {
    StringBuilder source = new StringBuilder();
    example
        .lines()
        .filter(line -> line.startsWith("import "))
        .forEach(line -> source.append(line).append('\n'));
    source.append(
        "public class Example {\n  public static void main(String[] args) throws Exception {\n");
    example
        .lines()
        .filter(line -> !line.startsWith("import "))
        .forEach(line -> source.append("    ").append(line).append('\n'));
    return source.append("  }\n}\n").toString();
  }

  /** Compiles and runs an example, and gives back what it prints. */
  private String run(String example) throws Exception {
    Path file = Files.writeString(folder.resolve("Example.java"), program(example));
    compile(file);
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      Method main = loader.loadClass("Example").getMethod("main", String[].class);
      return printedBy(() -> main.invoke(null, (Object) new String[0]));
    }
  }

  private static void compile(Path file) throws IOException {
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    StringWriter complaints = new StringWriter();
    try (StandardJavaFileManager files =
        compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
      List<String> options =
          List.of(
              "-Xlint:all",
              "-Werror",
              "-classpath",
              System.getProperty("java.class.path"),
              "-proc:none",
              "-d",
              file.getParent().toString());
      Iterable<? extends JavaFileObject> sources = files.getJavaFileObjects(file);
      assertEquals(
          true,
          compiler.getTask(complaints, files, null, options, null, sources).call(),
          () -> "the README's example does not compile:\n" + complaints);
    }
  }

  /** Something that may throw anything. */
  private interface Work {
    void run() throws Exception;
  }

  private static String printedBy(Work work) throws Exception {
    PrintStream before = System.out;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try {
      work.run();
    } finally {
      System.setOut(before);
    }
    return printed.toString(StandardCharsets.UTF_8);
  }

  /** A spot of 5 pixels radius that goes from left to right in a second, with 40 kev/s. */
  static void writeMovingSpot(Path file) throws IOException {
    SensorGeometry geometry = new SensorGeometry(128, 128);
    Random random = new Random(1);
    List<EventPacket> packets = new ArrayList<>();
    for (int start = 0; start < 1_000_000; start += 10_000) {
      EventPacket packet = new EventPacket(400);
      for (int timeUs = start; timeUs < start + 10_000; timeUs += 25) {
        double angle = 2 * Math.PI * random.nextDouble();
        double radius = 5 * Math.sqrt(random.nextDouble());
        packet.append(
            timeUs,
            (int) Math.round(20 + 80e-6 * timeUs + radius * Math.cos(angle)),
            (int) Math.round(64 + radius * Math.sin(angle)),
            random.nextBoolean());
      }
      packets.add(packet);
    }
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(geometry)).orElseThrow()) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      writer.finish();
    }
  }
}
