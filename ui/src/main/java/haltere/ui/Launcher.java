package haltere.ui;

import haltere.ui.command.HaltereProgram;

/** The main class. It separates class loading: commands load no class of the window. */
public final class Launcher {
  private Launcher() {}

  /** Runs the command line and ends the process with its status. */
  public static void main(String[] args) {
    // AWT draws text into pictures only, nothing on a screen
    System.setProperty("java.awt.headless", "true");
    System.exit(HaltereProgram.main(args, new JavaFxWindow()));
  }
}
