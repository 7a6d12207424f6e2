package haltere.ui.command;

import java.io.PrintStream;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Path;
import java.util.Map;

/**
 * The environment of a command: streams, terminal, variables. The program uses the process, tests
 * their own.
 *
 * @param in standard input
 * @param out standard output, for results
 * @param err standard error, for messages, warnings and the progress bar
 * @param outIsTerminal whether {@code out} is a terminal
 * @param errIsTerminal whether {@code err} is a terminal, so that a progress bar makes sense
 * @param environment the environment's variables
 * @param folder base of the demonstration's relative paths
 * @param window opens the viewer
 */
record CommandEnvironment(
    ReadableByteChannel in,
    PrintStream out,
    PrintStream err,
    boolean outIsTerminal,
    boolean errIsTerminal,
    Map<String, String> environment,
    Path folder,
    WindowOpener window) {
  CommandEnvironment {
    environment = Map.copyOf(environment);
  }
}
