package haltere.ui.viewer.action;

import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.property.ObjectProperty;
import javafx.beans.value.ObservableBooleanValue;

/**
 * Something that a person can do, as menus, the command palette and the list of keys show it.
 *
 * @param id unique, lower case with hyphens
 * @param words what a menu says; with a dot at its end it asks for more before anything happens
 * @param menu where it stands, such as {@code View/Theme}; empty for one that only the palette has
 * @param key such as {@code Shortcut+O}, {@code F11}, {@code Space} or {@code Shift+Comma}, or
 *     empty. Keys without Ctrl or Alt do nothing while text is entered.
 * @param help one sentence, or empty if the words say all
 * @param work what is done
 * @param on whether what it switches is on; empty for what is no switch
 * @param obstacle why it cannot be done now, in a few words; empty if it can
 */
public record ViewerAction(
    String id,
    String words,
    String menu,
    String key,
    String help,
    Runnable work,
    Optional<ObservableBooleanValue> on,
    Supplier<String> obstacle) {
  static final Supplier<String> NONE = () -> "";

  /** Something to do, which the table of commands describes. */
  public static ViewerAction of(String id, Runnable work) {
    return listed(id, work, Optional.empty(), NONE);
  }

  /** Something to do that the table does not list, without a key. */
  public static ViewerAction of(String id, String words, String menu, Runnable work) {
    return new ViewerAction(id, words, menu, "", "", work, Optional.empty(), NONE);
  }

  /** What the table lists under an id. */
  static ViewerAction listed(
      String id, Runnable work, Optional<ObservableBooleanValue> on, Supplier<String> obstacle) {
    ActionTable.Line line = ActionTable.line(id);
    return new ViewerAction(
        id, line.words(), line.menu(), line.key(), line.help(), work, on, obstacle);
  }

  /** One of several choices: on while a property has its value. */
  public static <T> ViewerAction choice(
      String id, String words, String menu, ObjectProperty<T> property, T value) {
    return new ViewerAction(
        id,
        words,
        menu,
        "",
        "",
        () -> property.set(value),
        Optional.of(property.isEqualTo(value)),
        NONE);
  }

  /** The same, explained by a sentence. */
  public ViewerAction withHelp(String sentence) {
    return new ViewerAction(id, words, menu, key, sentence, work, on, obstacle);
  }

  /** Whether its key means nothing while text is entered. */
  boolean hasPlainKey() {
    return !key.isEmpty()
        && !key.contains("Shortcut+")
        && !key.contains("Ctrl+")
        && !key.contains("Alt+")
        && !key.matches("(Shift\\+)?F\\d+");
  }
}
