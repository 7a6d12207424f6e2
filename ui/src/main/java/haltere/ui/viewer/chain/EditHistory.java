package haltere.ui.viewer.chain;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.function.Function;

/**
 * What a person has changed, to be taken back and done again. Changes of the same value that follow
 * each other closely, as when a slider is dragged, are one.
 */
public final class EditHistory {
  /** A change. */
  private record Step(String words, Object subject, Runnable undo, Runnable redo, long nanos) {}

  private static final long TOGETHER_NANOS = 1_000_000_000;
  private static final int MAX_CHANGES = 200;

  private final Deque<Step> done = new ArrayDeque<>();
  private final Deque<Step> undone = new ArrayDeque<>();
  private Runnable listener = () -> {};

  /** Calls something after each change, be it made or taken back. */
  public void onChange(Runnable newListener) {
    listener = newListener;
  }

  /**
   * Remembers a change that has been made at a time; what had been taken back before is forgotten.
   * Changes of an equal subject may be taken as one.
   */
  void made(String words, Object subject, Runnable undo, Runnable redo, long nanos) {
    undone.clear();
    Step last = done.peek();
    boolean together =
        last != null && last.subject().equals(subject) && nanos - last.nanos() < TOGETHER_NANOS;
    if (together) {
      done.pop();
    }
    done.push(new Step(words, subject, together ? last.undo() : undo, redo, nanos));
    if (done.size() > MAX_CHANGES) {
      done.removeLast();
    }
    listener.run();
  }

  /** Forgets a change that could not be made. */
  void forget(Object subject) {
    done.removeIf(step -> step.subject() == subject);
    undone.removeIf(step -> step.subject() == subject);
    listener.run();
  }

  /** Whether there is a change to take back. */
  public boolean canUndo() {
    return !done.isEmpty();
  }

  /** Whether there is a change to make once more. */
  public boolean canRedo() {
    return !undone.isEmpty();
  }

  /** Takes the last change back; what it was, or empty if there is none. */
  public String undo() {
    return go(done, undone, Step::undo);
  }

  /** Makes the change that was taken back last once more; what it was, or empty. */
  public String redo() {
    return go(undone, done, Step::redo);
  }

  private String go(Deque<Step> from, Deque<Step> to, Function<Step, Runnable> way) {
    if (from.isEmpty()) {
      return "";
    }
    Step step = from.pop();
    to.push(step);
    way.apply(step).run();
    listener.run();
    return step.words();
  }

  /** Forgets everything. */
  void clear() {
    done.clear();
    undone.clear();
  }
}
