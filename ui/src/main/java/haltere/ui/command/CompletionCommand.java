package haltere.ui.command;

import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;
import picocli.CommandLine.Parameters;

/** Writes a script with which a shell completes commands and options. */
@Command(
    name = "completion",
    description = {
      "Print a script that completes commands and options in a shell.",
      "bash, zsh: source <(haltere completion bash). fish: haltere completion fish | source"
    })
final class CompletionCommand extends Subcommand {
  enum Shell {
    /** Also the script for zsh, which loads bash's completion. */
    BASH,
    ZSH,
    FISH
  }

  /** The choices of an option or a parameter in picocli's script. */
  private static final Pattern CHOICES = Pattern.compile("_args=\\([^)]*\\)");

  @Parameters(index = "0", paramLabel = "bash|zsh|fish", description = "The shell.")
  Shell shell;

  private final Supplier<CommandLine> program;

  /** The supplier is called on request: it has all commands. */
  CompletionCommand(Supplier<CommandLine> program) {
    this.program = program;
  }

  @Override
  public Integer call() {
    CommandLine all = program.get();
    result(shell == Shell.FISH ? fish(all) : bash(all));
    return OK;
  }

  /** Choices in the spelling of the documents; the parser accepts either case. */
  private static String bash(CommandLine program) {
    return CHOICES
        .matcher(AutoComplete.bash(program.getCommandName(), program))
        .replaceAll(choices -> choices.group().toLowerCase(Locale.ROOT));
  }

  /** A line for each command, option and list of choices, from the model of the command line. */
  private static String fish(CommandLine program) {
    String complete = "complete -c " + program.getCommandName();
    StringBuilder script = new StringBuilder();
    arguments(complete + " -n __fish_use_subcommand", program.getCommandSpec(), script);
    for (Map.Entry<String, CommandLine> command : program.getSubcommands().entrySet()) {
      String[] help = command.getValue().getCommandSpec().usageMessage().description();
      script.append(complete + " -n __fish_use_subcommand -f -a " + command.getKey());
      script.append(" -d " + quoted(help[0]) + "\n");
      String inCommand = complete + " -n '__fish_seen_subcommand_from " + command.getKey() + "'";
      arguments(inCommand, command.getValue().getCommandSpec(), script);
    }
    return script.toString().strip();
  }

  private static void arguments(String complete, CommandSpec command, StringBuilder script) {
    for (OptionSpec option : command.options()) {
      script.append(complete + option(option) + choices(option) + "\n");
    }
    for (PositionalParamSpec parameter : command.positionalParameters()) {
      String choices = choices(parameter);
      script.append(choices.isEmpty() ? "" : complete + choices + "\n");
    }
  }

  private static String option(OptionSpec option) {
    StringBuilder words = new StringBuilder();
    for (String name : option.names()) {
      words.append(name.startsWith("--") ? " -l " + name.substring(2) : " -s " + name.substring(1));
    }
    if (option.arity().max() > 0) {
      words.append(" -r");
    }
    String help = option.description().length == 0 ? "" : option.description()[0];
    return words + " -d " + quoted(help);
  }

  private static String choices(ArgSpec argument) {
    return argument.completionCandidates() == null
        ? ""
        : " -f -a '"
            + String.join(" ", argument.completionCandidates()).toLowerCase(Locale.ROOT)
            + "'";
  }

  private static String quoted(String text) {
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'";
  }
}
