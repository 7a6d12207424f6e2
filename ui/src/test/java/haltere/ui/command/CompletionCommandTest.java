package haltere.ui.command;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.ui.export.Mp4Writer;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Scripts with which shells complete commands and options. */
class CompletionCommandTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"bash", "zsh", "fish"})
  void scriptContainsCommandsAndOptions(String shell) {
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
  void scriptIsValidInItsShell(String shell) throws Exception {
    assertEquals("", said(shell, "-n", script(shell)));
  }

  @ParameterizedTest
  @CsvSource({
    "haltere completion |, bash fish zsh",
    "haltere convert --rows |, bottom top",
    "haltere simulate rend|, rendered-fly",
    "haltere --vers|, --version",
    "haltere convert --out-f|, --out-format"
  })
  void wordsAreCompletedInBashAndFish(String line, String expected) throws Exception {
    String typed = line.substring(0, line.length() - 1);
    String last = typed.substring(typed.lastIndexOf(' ') + 1);
    String bash =
        "COMP_WORDS=(%s \"%s\"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); source '%s';"
                .formatted(typed.substring(0, typed.length() - last.length()), last, script("bash"))
            + " _complete_haltere 2>/dev/null; printf '%s\\n' ${COMPREPLY[@]}";
    assertEquals(expected, sortedWords(said("bash", "-c", bash)));
    String fish = "source '%s'; complete -C '%s'".formatted(script("fish"), typed);
    assertEquals(expected, sortedWords(said("fish", "--no-config", "-c", fish)));
  }

  private static String sortedWords(String lines) {
    return lines.lines().map(line -> line.split("\\s")[0]).sorted().collect(joining(" "));
  }

  private String script(String shell) throws IOException {
    Path script = folder.resolve("script." + shell);
    Files.writeString(script, CommandRun.of("completion", shell).out());
    return script.toString();
  }

  /** What a shell says; the test is skipped without it. */
  private String said(String... command) throws Exception {
    Assumptions.assumeTrue(Mp4Writer.onPath(command[0]).isPresent(), "there is no " + command[0]);
    Process shell = new ProcessBuilder(command).redirectErrorStream(true).start();
    String text = new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, shell.waitFor(), text);
    return text;
  }

  @Test
  void unknownShellIsAWrongArgument() {
    assertEquals(2, CommandRun.of("completion", "csh").status());
    assertEquals(2, CommandRun.of("completion").status());
  }
}
