package haltere.ui.command;

import java.nio.file.Path;

/** A batch in a process of its own, to be killed: arguments are inputs, chain and results. */
final class BatchProcess {
  private BatchProcess() {}

  public static void main(String[] args) {
    CommandRun run =
        CommandRun.of(
            "batch",
            Path.of(args[0]),
            "--chain",
            Path.of(args[1]),
            "--out",
            Path.of(args[2]),
            "--resume");
    System.out.println(run.err());
    System.exit(run.status());
  }
}
