package haltere.ui.viewer.chain;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * The history of changes for undo and redo. Successive changes of the same value, such as those of
 * a drag, are one step.
 */
public final class EditHistory {
  private record Edit(
      String label, Object owner, Object subject, Runnable undo, Runnable redo, long nanos) {}

  private static final long MERGE_NANOS = 1_000_000_000;
  private static final int MAX_CHANGES = 200;

  private final Deque<Edit> done = new ArrayDeque<>();
  private final Deque<Edit> undone = new ArrayDeque<>();
  private Runnable listener = () -> {};

  /** Adds a listener to changes, undone or redone ones too. */
  public void onChange(Runnable newListener) {
    listener = newListener;
  }

  /**
   * Adds a change of an owner's chain at a time; undone changes are discarded. Successive changes
   * of an equal subject may become one.
   */
  void made(String label, Object owner, Object subject, Runnable undo, Runnable redo, long nanos) {
    undone.clear();
    Edit last = done.peek();
    boolean together =
        last != null
            && last.owner() == owner
            && last.subject().equals(subject)
            && nanos - last.nanos() < MERGE_NANOS;
    if (together) {
      done.pop();
    }
    done.push(new Edit(label, owner, subject, together ? last.undo() : undo, redo, nanos));
    if (done.size() > MAX_CHANGES) {
      done.removeLast();
    }
    listener.run();
  }

  /** Removes a failed change by its subject, or those of an owner whose chain is closed. */
  public void remove(Object of) {
    Predicate<Edit> unwanted = step -> step.subject() == of || step.owner() == of;
    done.removeIf(unwanted);
    undone.removeIf(unwanted);
  }

  /** Whether there is a change to undo. */
  public boolean canUndo() {
    return !done.isEmpty();
  }

  /** Whether there is a change to redo. */
  public boolean canRedo() {
    return !undone.isEmpty();
  }

  /** Undoes the last change; returns its label, or empty text. */
  public String undo() {
    return go(done, undone, Edit::undo);
  }

  /** Redoes the last undone change; returns its label, or empty text. */
  public String redo() {
    return go(undone, done, Edit::redo);
  }

  private String go(Deque<Edit> from, Deque<Edit> to, Function<Edit, Runnable> way) {
    if (from.isEmpty()) {
      return "";
    }
    Edit step = from.pop();
    to.push(step);
    way.apply(step).run();
    listener.run();
    return step.label();
  }
}
