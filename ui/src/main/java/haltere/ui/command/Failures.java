package haltere.ui.command;

import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterFailure;
import haltere.core.settings.SettingsProblem;
import haltere.core.stream.internal.Reason;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.util.regex.Pattern;

/** Turns any failure into one line with file, cause and advice. */
final class Failures {
  private static final Pattern ENDLESS = Pattern.compile("(\\S{100})\\S{1000,}(\\S{50})");
  private static final Pattern CONTROL = Pattern.compile("[\\p{Cntrl}\\x80-\\x9f&&[^\n\t]]");

  private Failures() {}

  /** The one line for a failure, without the program's name. */
  static String describe(Throwable failure) {
    return printable(shortened(sentence(failure).strip().replaceAll("\\s*\\R\\s*", " ")));
  }

  /** A text that does not control a terminal, whatever the names of files in it. */
  static String printable(String text) {
    return CONTROL.matcher(text).replaceAll("?");
  }

  private static String sentence(Throwable failure) {
    if (isInterruption(failure)) {
      return "interrupted; unfinished output has been removed";
    }
    if (failure instanceof UncheckedIOException unchecked) {
      return sentence(unchecked.getCause());
    }
    if (failure instanceof FilterFailure && !(failure.getCause() instanceof UncheckedIOException)) {
      return failure.getMessage()
          + "; this is a fault in the filter: switch it off, or report it with what --debug prints";
    }
    if (failure instanceof FileSystemException file) {
      return fileProblem(file);
    }
    if (failure instanceof OutOfMemoryError) {
      return "not enough memory ("
          + failure.getMessage()
          + "); give the program more with JAVA_OPTS=-Xmx2g";
    }
    if (failure instanceof CommandProblem
        || failure instanceof ChainProblem
        || failure instanceof SettingsProblem
        || failure instanceof FilterFailure
        || failure instanceof IOException) {
      return Reason.of(failure);
    }
    return "unexpected failure: "
        + failure
        + "; this is a fault in the program: report it with what --debug prints";
  }

  /** Whether the work was stopped from outside; files then fail in many ways. */
  static boolean isInterruption(Throwable failure) {
    return Thread.currentThread().isInterrupted()
        || failure instanceof InterruptedException
        || failure instanceof InterruptedIOException
        || failure instanceof ClosedByInterruptException;
  }

  private static String fileProblem(FileSystemException problem) {
    String file = problem.getFile() == null ? "" : problem.getFile() + ": ";
    if (problem instanceof AccessDeniedException) {
      return file + "permission denied; change its mode or owner, or choose another place";
    }
    if (problem instanceof FileAlreadyExistsException) {
      return file + "exists already; give --overwrite to replace it";
    }
    return Reason.of(problem);
  }

  /** The problem of a text file that is no text. */
  static CommandProblem notText(Object file, CharacterCodingException cause) {
    return new CommandProblem(file + ": this is not UTF-8 text", cause);
  }

  /** A name that is longer than any file's, with its middle left out. */
  static String shortened(String line) {
    return ENDLESS.matcher(line).replaceAll("$1...$2");
  }
}
