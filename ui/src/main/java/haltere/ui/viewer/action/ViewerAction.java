package haltere.ui.viewer.action;

import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.property.ObjectProperty;
import javafx.beans.value.ObservableBooleanValue;

/**
 * A command, as in menus, command palette and list of keys.
 *
 * @param id unique, lower case with hyphens
 * @param label label in menus; with an ellipsis, a dialog follows
 * @param menu path of its menu, such as {@code View/Theme}; empty for one that only the palette has
 * @param key such as {@code Shortcut+O}, {@code F11}, {@code Space} or {@code Shift+Comma}, or
 *     empty. Keys without Ctrl or Alt do nothing while text is entered.
 * @param help one sentence, or empty
 * @param work runs the command
 * @param on state of a toggle; empty for other commands
 * @param obstacle the reason why it is unavailable; empty if it is available
 */
public record ViewerAction(
    String id,
    String label,
    String menu,
    String key,
    String help,
    Runnable work,
    Optional<ObservableBooleanValue> on,
    Supplier<String> obstacle) {
  static final Supplier<String> NONE = () -> "";

  /** Something to do that the table does not list, without a key. */
  public static ViewerAction of(String id, String label, String menu, Runnable work) {
    return new ViewerAction(id, label, menu, "", "", work, Optional.empty(), NONE);
  }

  /** The action of an id in the table. */
  static ViewerAction listed(
      String id, Runnable work, Optional<ObservableBooleanValue> on, Supplier<String> obstacle) {
    ActionTable.ActionLine line = ActionTable.line(id);
    return new ViewerAction(
        id, line.label(), line.menu(), line.key(), line.help(), work, on, obstacle);
  }

  /** One of several choices: on while a property has its value. */
  public static <T> ViewerAction choice(
      String id, String label, String menu, ObjectProperty<T> property, T value) {
    return new ViewerAction(
        id,
        label,
        menu,
        "",
        "",
        () -> property.set(value),
        Optional.of(property.isEqualTo(value)),
        NONE);
  }

  /** The same, explained by a sentence. */
  public ViewerAction withHelp(String sentence) {
    return new ViewerAction(id, label, menu, key, sentence, work, on, obstacle);
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
