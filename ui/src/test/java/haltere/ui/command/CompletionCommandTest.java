package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Scripts with which shells complete commands and options. */
class CompletionCommandTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"bash", "zsh", "fish"})
  void aScriptNamesCommandsAndOptions(String shell) {
    CommandRun run = CommandRun.of("completion", shell);
    assertEquals(0, run.status(), run.err());
    assertEquals("", run.err());
    String option = shell.equals("fish") ? "-l out-format" : "--out-format";
    for (String word : List.of("convert", "simulate", "completion", option)) {
      assertTrue(run.out().contains(word), word);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"bash", "zsh", "fish"})
  void theShellUnderstandsItsScript(String shell) throws Exception {
    String[] places = System.getenv().getOrDefault("PATH", "").split(File.pathSeparator);
    Assumptions.assumeTrue(
        List.of(places).stream().anyMatch(place -> Files.exists(Path.of(place, shell))),
        "there is no " + shell);
    Path script = folder.resolve("script");
    Files.writeString(script, CommandRun.of("completion", shell).out());
    Process checked = new ProcessBuilder(shell, "-n", script.toString()).inheritIO().start();
    assertEquals(0, checked.waitFor());
  }

  @Test
  void anotherShellIsAWrongArgument() {
    assertEquals(2, CommandRun.of("completion", "csh").status());
    assertEquals(2, CommandRun.of("completion").status());
  }
}
