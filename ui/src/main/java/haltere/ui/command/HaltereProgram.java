package haltere.ui.command;

import haltere.ui.command.terminal.Interruption;
import haltere.ui.command.terminal.StandardOutput;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Model.UsageMessageSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * The command line: finds the command, runs it and maps failures to a line and a status. Loads only
 * the requested command.
 *
 * <p>Thread rule: everything runs on the calling thread.
 */
public final class HaltereProgram {
  /** Commands by task, the most common ones first. */
  private static final List<Group> GROUPS =
      List.of(
          new Group("View and inspect", "view", "info"),
          new Group("Work on recordings", "wings", "track", "orient", "run", "batch", "convert"),
          new Group("Make recordings", "devices", "record", "simulate", "scenes"),
          new Group("More", "filters", "example", "bench", "completion"));

  private static final List<String> COMMANDS =
      GROUPS.stream().flatMap(group -> Stream.of(group.commands)).toList();

  private record Group(String title, String... commands) {}

  /** Values of an option, which users type in lower case. */
  private static final Pattern CHOICES =
      Pattern.compile("expected one of \\[(.*)] \\(case-insensitive\\)");

  private static final int HELP_WIDTH = 80;
  private static final int COMMAND_COLUMN = 14;

  private final CommandEnvironment surroundings;

  HaltereProgram(CommandEnvironment surroundings) {
    this.surroundings = surroundings;
  }

  /**
   * Runs the command of the process's arguments, waits for it and returns the exit status of the
   * process.
   */
  public static int main(String[] args, WindowOpener window) {
    Interruption interruption = Interruption.install();
    int status = Subcommand.FAILED;
    try {
      StandardOutput standardOutput = new StandardOutput();
      PrintStream out =
          new PrintStream(
              new BufferedOutputStream(standardOutput, 1 << 14), false, StandardCharsets.UTF_8);
      PrintStream err =
          new PrintStream(new FileOutputStream(FileDescriptor.err), true, StandardCharsets.UTF_8);
      FileChannel in = new FileInputStream(FileDescriptor.in).getChannel();
      CommandEnvironment process =
          new CommandEnvironment(
              in, out, err, isTerminal(1), isTerminal(2), System.getenv(), Path.of(""), window);
      status = new HaltereProgram(process).run(args);
      Optional<String> failure = standardOutput.failure();
      failure.ifPresent(line -> err.print("haltere: " + line + "\n"));
      status = failure.isPresent() && status == Subcommand.OK ? Subcommand.FAILED : status;
    } finally {
      interruption.finished(status);
    }
    return status;
  }

  /** Whether a stream of the process is a terminal; Java itself only knows of two together. */
  private static boolean isTerminal(int descriptor) {
    Path link = Path.of("/proc/self/fd/" + descriptor);
    try {
      String target = Files.readSymbolicLink(link).toString();
      return target.startsWith("/dev/pts/") || target.startsWith("/dev/tty");
    } catch (IOException | RuntimeException noSuchFileSystem) {
      return System.console() != null;
    }
  }

  /** Runs a command by its arguments and returns 0, 1 or 2. */
  int run(String... args) {
    int status;
    try {
      for (String problem : ExtensionFolder.open(args, surroundings.environment())) {
        surroundings.err().print("haltere: warning: " + problem + "\n");
      }
      status = commandLine(args).execute(args);
    } catch (CommandProblem | IOException | Error failure) {
      status = failed(failure, List.of(args).contains("--debug"));
    }
    surroundings.out().flush();
    surroundings.err().flush();
    return status;
  }

  CommandLine commandLine(String... args) {
    CommandLine program = inOrder(new HaltereCommand());
    String wanted = Stream.of(args).filter(arg -> !arg.startsWith("-")).findFirst().orElse("");
    boolean known = COMMANDS.contains(wanted);
    for (String name : COMMANDS) {
      if (!known || name.equals(wanted)) {
        program.addSubcommand(name, inOrder(command(name)));
      }
    }
    program
        .getHelpSectionMap()
        .put(UsageMessageSpec.SECTION_KEY_COMMAND_LIST, HaltereProgram::commandList);
    boolean coloured =
        surroundings.outIsTerminal() && !surroundings.environment().containsKey("NO_COLOR");
    return program
        .setExpandAtFiles(false)
        .setCaseInsensitiveEnumValuesAllowed(true)
        .registerConverter(Path.class, HaltereProgram::path)
        .setColorScheme(Help.defaultColorScheme(coloured ? Ansi.ON : Ansi.OFF))
        .setOut(new java.io.PrintWriter(surroundings.out(), true))
        .setErr(new java.io.PrintWriter(surroundings.err(), true))
        .setParameterExceptionHandler(this::wrongArguments)
        .setExecutionStrategy(HaltereProgram::executed)
        .setExecutionExceptionHandler(
            (problem, command, parsed) -> failed(problem, isDebug(command)));
  }

  private static Path path(String name) {
    if (name.isEmpty()) {
      throw new CommandLine.TypeConversionException("the name of a file is empty");
    }
    return Path.of(name);
  }

  /** Commands in groups, each with the first sentence of its description. */
  private static String commandList(Help help) {
    if (help.subcommands().isEmpty()) {
      return "";
    }
    Help.TextTable table =
        Help.TextTable.forColumnWidths(
            help.colorScheme(), COMMAND_COLUMN, HELP_WIDTH - COMMAND_COLUMN);
    for (Group group : GROUPS) {
      table.addRowValues(help.colorScheme().text("@|bold " + group.title + ":|@"));
      for (String name : group.commands) {
        Help command = help.subcommands().get(name);
        String[] description = command.commandSpec().usageMessage().description();
        table.addRowValues(
            help.colorScheme().commandText("  " + name), help.colorScheme().text(description[0]));
      }
    }
    return table.toString();
  }

  private static int executed(ParseResult parsed) {
    if (!parsed.unmatched().isEmpty() && !parsed.hasSubcommand()) {
      // the help was requested of a command that does not exist
      throw new UnmatchedArgumentException(parsed.commandSpec().commandLine(), parsed.unmatched());
    }
    int status = new CommandLine.RunLast().execute(parsed);
    CommandLine last = parsed.asCommandLineList().get(parsed.asCommandLineList().size() - 1);
    return last.getCommand() instanceof Subcommand command
        ? command.statusWithFailures(status)
        : status;
  }

  /** Options in the order of their declaration, common ones last. */
  private CommandLine inOrder(Callable<Integer> command) {
    CommandLine line = new CommandLine(((Subcommand) command).in(surroundings));
    line.getCommandSpec().usageMessage().sortOptions(false).sortSynopsis(false);
    return line;
  }

  /**
   * Makes a command. It returns an interface, so that Java need not load all of them to check it.
   */
  private Callable<Integer> command(String name) {
    return switch (name) {
      case "view" -> new ViewCommand();
      case "info" -> new InfoCommand();
      case "convert" -> new ConvertCommand();
      case "run" -> new RunCommand();
      case "track" -> new TrackCommand();
      case "wings" -> new WingsCommand();
      case "orient" -> new OrientCommand();
      case "batch" -> new BatchCommand();
      case "simulate" -> new SimulateCommand();
      case "scenes" -> new ScenesCommand();
      case "filters" -> new FiltersCommand();
      case "example" -> new ExampleCommand();
      case "devices" -> new DevicesCommand();
      case "record" -> new RecordCommand();
      case "completion" -> new CompletionCommand(this::commandLine);
      case "bench" -> new BenchCommand();
      default -> throw new IllegalArgumentException(name);
    };
  }

  private int wrongArguments(ParameterException problem, String... args) {
    CommandLine command = problem.getCommandLine();
    List<String> unknown = command.getUnmatchedArguments();
    if (problem instanceof CommandLine.MissingParameterException && !unknown.isEmpty()) {
      return wrongArguments(new UnmatchedArgumentException(command, unknown), args);
    }
    if (isDebug(command)) {
      problem.printStackTrace(surroundings.err());
    }
    String name = command.getCommandSpec().qualifiedName();
    String line =
        Failures.shortened(problem.getMessage().strip())
            .replaceFirst("is not an? (int|long)$", "is no whole number")
            .replaceFirst("is not a double$", "is no number")
            .replaceFirst(
                "option option (.*) \\((.*)\\) should be in KEY=VALUE", "option $1 must be in $2");
    line =
        CHOICES
            .matcher(line)
            .replaceFirst(
                choices -> "expected one of " + choices.group(1).toLowerCase(Locale.ROOT));
    if (problem instanceof UnmatchedArgumentException unmatched) {
      boolean isCommand = command.getParent() == null && !unmatched.isUnknownOption();
      line = isCommand ? "there is no command " + unmatched.getUnmatched().get(0) : line;
      String before = isCommand ? name + " " : "";
      String similar = String.join(" or " + before, unmatched.getSuggestions());
      line += similar.isEmpty() ? "" : "\nDid you mean: " + before + similar + "?";
    }
    Help help = command.getHelp();
    String usage = help.synopsisHeading() + help.synopsis(help.synopsisHeadingLength());
    String shown = Failures.printable(line);
    surroundings.err().print("%s: %s\n%sMore: %s --help\n".formatted(name, shown, usage, name));
    return Subcommand.WRONG_ARGUMENTS;
  }

  private int failed(Throwable problem, boolean debug) {
    if (debug) {
      problem.printStackTrace(surroundings.err());
    }
    if (StandardOutput.Gone.isCause(problem)) {
      return Subcommand.OK;
    }
    surroundings.err().print("haltere: " + Failures.describe(problem) + "\n");
    return Subcommand.FAILED;
  }

  private static boolean isDebug(CommandLine command) {
    return command.getCommand() instanceof Subcommand subcommand && subcommand.isDebug();
  }
}
