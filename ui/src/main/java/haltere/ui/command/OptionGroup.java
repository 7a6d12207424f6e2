package haltere.ui.command;

import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options that several commands share. */
abstract class OptionGroup {
  @Spec(Spec.Target.MIXEE)
  CommandSpec command;

  Subcommand subcommand() {
    return (Subcommand) command.userObject();
  }

  ParameterException wrong(String message) {
    return new ParameterException(command.commandLine(), message);
  }
}
