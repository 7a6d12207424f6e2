package haltere.ui.command.terminal;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.Optional;

/**
 * The process's standard output with the cause of a write failure, which a print stream does not
 * keep: a reader that has ended (such as {@code head}) is no failure, a full disk is one.
 */
public final class StandardOutput extends OutputStream {
  /** Standard output accepts no more; {@link #failure()} has the reason, if it is a failure. */
  public static final class Gone extends IOException {
    private static final long serialVersionUID = 1;

    /** Without a message: the process prints it once, at its end. */
    public Gone() {
      super("the standard output is closed");
    }

    /** Whether a failure or one of its causes is of this class. */
    public static boolean isCause(Throwable failure) {
      return failure != null && (failure instanceof Gone || isCause(failure.getCause()));
    }
  }

  private final OutputStream process;
  private IOException problem;

  /** That of this process. */
  public StandardOutput() {
    this(new FileOutputStream(FileDescriptor.out));
  }

  StandardOutput(OutputStream process) {
    this.process = process;
  }

  @Override
  public void write(int value) throws IOException {
    write(new byte[] {(byte) value}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    try {
      process.write(bytes, offset, length);
    } catch (IOException thrown) {
      problem = thrown;
      throw thrown;
    }
  }

  /**
   * The reason of incomplete output in one line; empty after success or if the reader has ended.
   */
  public Optional<String> failure() {
    if (problem == null || isClosedPipe(problem)) {
      return Optional.empty();
    }
    return Optional.of("the standard output cannot be written: " + problem.getMessage());
  }

  private static boolean isClosedPipe(IOException problem) {
    String message = String.valueOf(problem.getMessage()).toLowerCase(Locale.ROOT);
    return message.contains("broken pipe") || message.contains("pipe is being closed");
  }
}
