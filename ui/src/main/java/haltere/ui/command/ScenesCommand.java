package haltere.ui.command;

import haltere.core.simulation.Scenes;
import picocli.CommandLine.Command;

/** Lists the simulated scenes and their settings. */
@Command(
    name = "scenes",
    description =
        "List the simulated scenes with their settings: unit, range, default and meaning.")
final class ScenesCommand extends SettingsListing {
  ScenesCommand() {
    super(Scenes::all, Scenes::named);
  }
}
