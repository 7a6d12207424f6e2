package haltere.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardWatchEventKinds;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The program as a process of its own. */
@Timeout(60)
class LauncherTest {
  @TempDir Path folder;

  private Process start(String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-Xmx64m"));
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.add(Launcher.class.getName());
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().remove("DISPLAY");
    builder.environment().remove("JAVA_TOOL_OPTIONS");
    return builder.start();
  }

  private static String text(java.io.InputStream stream) throws IOException {
    return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
  }

  @Test
  void processStatusIsTheStatusOfTheCommand() throws Exception {
    Process good = start("--version");
    assertTrue(text(good.getInputStream()).startsWith("haltere "));
    assertEquals(0, good.waitFor());
    Process bad = start("info", "missing.aedat");
    assertEquals("haltere: missing.aedat: there is no such file\n", text(bad.getErrorStream()));
    assertEquals(1, bad.waitFor());
    Process wrong = start("info");
    assertTrue(text(wrong.getErrorStream()).contains("Usage: haltere info"));
    assertEquals(2, wrong.waitFor());
  }

  @Test
  void terminatedProcessRemovesItsUnfinishedOutput() throws Exception {
    try (WatchService watch = folder.getFileSystem().newWatchService()) {
      folder.register(watch, StandardWatchEventKinds.ENTRY_CREATE);
      Process process = start("simulate", "fly", "endless.aedat", "--duration", "100000");
      WatchKey created = watch.poll(30, TimeUnit.SECONDS);
      assertNotNull(created, "no file was begun");
      process.toHandle().destroy();
      String said = text(process.getErrorStream());
      assertEquals(143, process.waitFor(), said);
      assertTrue(said.contains("interrupted"), said);
      try (Stream<Path> files = Files.list(folder)) {
        assertEquals(List.of(), files.toList());
      }
    }
  }

  @Test
  void commandsLoadNoJavaFxClass() throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Xlog:class+load:file=classes.txt", "-cp"));
    command.add(System.getProperty("java.class.path"));
    command.addAll(List.of(Launcher.class.getName(), "filters"));
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    text(process.getInputStream());
    assertEquals(0, process.waitFor());
    String loaded = Files.readString(folder.resolve("classes.txt"));
    assertTrue(loaded.contains(" haltere.ui.command.FiltersCommand "));
    assertFalse(loaded.contains(" javafx."));
    assertFalse(loaded.contains(" haltere.ui.viewer."));
    assertFalse(loaded.contains(" haltere.ui.command.ConvertCommand "));
  }
}
