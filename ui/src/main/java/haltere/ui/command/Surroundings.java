package haltere.ui.command;

import java.io.PrintStream;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Path;
import java.util.Map;

/**
 * What a command can see of the machine it runs on. The program takes it from the process; a test
 * makes its own.
 *
 * @param in standard input
 * @param out takes results
 * @param err takes messages, warnings and the progress bar
 * @param outIsTerminal whether {@code out} is a terminal, so that a person reads it
 * @param errIsTerminal whether {@code err} is a terminal, so that a progress bar makes sense
 * @param environment the environment's variables
 * @param folder what relative paths of the demonstration start from
 * @param window opens the viewer
 */
record Surroundings(
    ReadableByteChannel in,
    PrintStream out,
    PrintStream err,
    boolean outIsTerminal,
    boolean errIsTerminal,
    Map<String, String> environment,
    Path folder,
    WindowOpener window) {
  Surroundings {
    environment = Map.copyOf(environment);
  }
}
