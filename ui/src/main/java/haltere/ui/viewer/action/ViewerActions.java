package haltere.ui.viewer.action;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.value.ObservableBooleanValue;

/**
 * All commands of the window. Each is added once; menus, keys, command palette and list of keys are
 * built from them.
 */
public final class ViewerActions {
  /** Actions by what added them, in the order of the first additions. */
  private final Map<String, List<ViewerAction>> actions = new LinkedHashMap<>();

  private final List<Runnable> listeners = new ArrayList<>();
  private Consumer<String> refusals = words -> {};

  /** Adds actions in the order of their menus; rejects a used id or key. */
  public void add(ViewerAction... added) {
    offer("added " + actions.size(), List.of(added));
  }

  /** The table's label of a command. */
  public static String label(String id) {
    return ActionTable.line(id).label();
  }

  /** Adds a command of the table. */
  public void add(String id, Runnable work) {
    add(id, work, ViewerAction.NONE);
  }

  /** Adds a command of the table, with why it cannot be done now; empty if it can. */
  public void add(String id, Runnable work, Supplier<String> obstacle) {
    add(ViewerAction.listed(id, work, Optional.empty(), obstacle));
  }

  /** Adds a switch of the table, which turns a property over. */
  public void add(String id, BooleanProperty on) {
    add(id, on, ViewerAction.NONE);
  }

  /** Adds a switch of the table, which turns a property over, with why it cannot be used now. */
  public void add(String id, BooleanProperty on, Supplier<String> obstacle) {
    add(id, on, () -> on.set(!on.get()), obstacle);
  }

  /** Adds a toggle of the table whose state is external, with the reason why it is unavailable. */
  public void add(String id, ObservableBooleanValue on, Runnable work, Supplier<String> obstacle) {
    add(ViewerAction.listed(id, work, Optional.of(on), obstacle));
  }

  /** Adds an action for each value of a property, with a common prefix of ids. */
  public <T> void addChoices(
      String id,
      String menu,
      ObjectProperty<T> property,
      Collection<T> values,
      Function<T, String> label) {
    for (T value : values) {
      String ending = label.apply(value).toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
      add(ViewerAction.choice(id + ending, label.apply(value), menu, property, value));
    }
  }

  /** Replaces the actions that were offered under the same name, at their place. */
  public void offer(String name, List<ViewerAction> offered) {
    List<ViewerAction> here = new ArrayList<>();
    actions.put(name, here);
    for (ViewerAction action : offered) {
      for (ViewerAction other : all()) {
        if (other.id().equals(action.id())) {
          throw new IllegalArgumentException("there is an action " + action.id() + " already");
        }
        if (!action.key().isEmpty() && other.key().equals(action.key())) {
          throw new IllegalArgumentException(
              action.key() + " is the key of " + other.id() + ", not of " + action.id());
        }
      }
      here.add(action);
    }
    listeners.forEach(Runnable::run);
  }

  /** All actions, in the order of their menus. */
  List<ViewerAction> all() {
    return actions.values().stream().flatMap(List::stream).toList();
  }

  /** The action of an id. */
  public Optional<ViewerAction> find(String id) {
    return all().stream().filter(action -> action.id().equals(id)).findFirst();
  }

  /** Runs the action of an id. */
  public void run(String id) {
    run(find(id).orElseThrow(() -> new IllegalArgumentException("no action " + id)));
  }

  /** Does what an action stands for, or reports why it cannot be done now. */
  void run(ViewerAction action) {
    String obstacle = action.obstacle().get();
    refusals.accept(obstacle.isEmpty() ? "" : action.label() + ": " + obstacle);
    if (obstacle.isEmpty()) {
      action.work().run();
    }
  }

  /** Reports for each command why it cannot be done now; empty if it can. */
  public void onRefusal(Consumer<String> listener) {
    refusals = listener;
  }

  /** The items of a menu, in order. */
  public List<ViewerAction> inMenu(String menu) {
    return all().stream().filter(action -> action.menu().equals(menu)).toList();
  }

  /** Adds a listener to changes of the actions. */
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }
}
