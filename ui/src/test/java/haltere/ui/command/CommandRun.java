package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A command that was run in this process, with what it wrote and its status.
 *
 * @param status 0, 1 or 2
 * @param out what went to the standard output
 * @param err what went to the standard error
 * @param windows what was opened in a window
 * @param bytes what went to the standard output, as it is
 */
public record CommandRun(
    int status, String out, String err, List<Optional<Path>> windows, byte[] bytes) {
  /** A command on a machine without display and terminal. */
  public static CommandRun of(Object... arguments) {
    return on(Machine.BARE, arguments);
  }

  /** A machine that a command runs on. */
  record Machine(
      Path folder, boolean terminal, boolean display, Optional<String> obstacle, byte[] input) {
    static final Machine BARE =
        new Machine(Path.of(""), false, false, Optional.empty(), new byte[0]);

    Machine withInput(byte[] bytes) {
      return new Machine(folder, terminal, display, obstacle, bytes);
    }

    Machine in(Path newFolder) {
      return new Machine(newFolder, terminal, display, obstacle, input);
    }

    Machine withTerminal() {
      return new Machine(folder, true, display, obstacle, input);
    }

    Machine withDisplay() {
      return new Machine(folder, terminal, true, obstacle, input);
    }

    Machine withObstacle(String line) {
      return new Machine(folder, terminal, display, Optional.of(line), input);
    }
  }

  static CommandRun on(Machine machine, Object... arguments) {
    List<Optional<Path>> windows = new ArrayList<>();
    WindowOpener window =
        new WindowOpener() {
          @Override
          public Optional<String> obstacle() {
            return machine.obstacle();
          }

          @Override
          public boolean hasDisplay() {
            return machine.display();
          }

          @Override
          public Optional<String> open(Optional<Path> file, ReadOptions options) {
            windows.add(file);
            return Optional.empty();
          }
        };
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    CommandEnvironment surroundings =
        new CommandEnvironment(
            Channels.newChannel(new ByteArrayInputStream(machine.input())),
            new PrintStream(out, false, StandardCharsets.UTF_8),
            new PrintStream(err, false, StandardCharsets.UTF_8),
            machine.terminal(),
            machine.terminal(),
            Map.of(),
            machine.folder(),
            window);
    String[] args = new String[arguments.length];
    for (int i = 0; i < arguments.length; i++) {
      args[i] = arguments[i].toString();
    }
    int status = new HaltereProgram(surroundings).run(args);
    return new CommandRun(
        status,
        out.toString(StandardCharsets.UTF_8),
        err.toString(StandardCharsets.UTF_8),
        windows,
        out.toByteArray());
  }

  /** The lines on the standard error. */
  List<String> errorLines() {
    return err.lines().toList();
  }
}
