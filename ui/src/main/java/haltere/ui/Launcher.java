package haltere.ui;

import haltere.ui.command.HaltereProgram;

/**
 * The program's main class. It decides nothing but which classes are loaded: a command never
 * touches those of the window.
 */
public final class Launcher {
  private Launcher() {}

  /** Runs the command line with its words and ends the process with its status. */
  public static void main(String[] args) {
    // words are drawn into pictures, nothing onto a screen of AWT
    System.setProperty("java.awt.headless", "true");
    System.exit(HaltereProgram.main(args, new JavaFxWindow()));
  }
}
