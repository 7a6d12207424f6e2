package haltere.ui.viewer.action;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
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
 * All that a person can do in the window. Whoever brings something adds it here once; menus, keys,
 * the command palette and the list of keys are made from it.
 */
public final class ViewerActions {
  private final Map<String, ViewerAction> actions = new LinkedHashMap<>();
  private final Map<String, List<ViewerAction>> offers = new HashMap<>();
  private final List<Runnable> listeners = new ArrayList<>();
  private Consumer<String> refusals = words -> {};

  /** Adds actions in the order of their menus; refuses an id or a key that is taken. */
  public void add(ViewerAction... added) {
    put(List.of(added));
    listeners.forEach(Runnable::run);
  }

  /** What the table calls a command. */
  public static String words(String id) {
    return ActionTable.line(id).words();
  }

  /** Adds a command of the table. */
  public void add(String id, Runnable work) {
    add(ViewerAction.of(id, work));
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

  /** Adds a switch of the table whose state somebody else keeps, with why it cannot be used now. */
  public void add(String id, ObservableBooleanValue on, Runnable work, Supplier<String> obstacle) {
    add(ViewerAction.listed(id, work, Optional.of(on), obstacle));
  }

  /** Adds an action for each value that a property may be given, whose ids begin alike. */
  public <T> void addChoices(
      String id,
      String menu,
      ObjectProperty<T> property,
      Collection<T> values,
      Function<T, String> words) {
    for (T value : values) {
      String ending = words.apply(value).toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
      add(ViewerAction.choice(id + ending, words.apply(value), menu, property, value));
    }
  }

  /** Puts actions in place of those that were offered under the same name before. */
  public void offer(String name, List<ViewerAction> offered) {
    offers.getOrDefault(name, List.of()).forEach(old -> actions.remove(old.id()));
    offers.put(name, offered);
    put(offered);
    listeners.forEach(Runnable::run);
  }

  private void put(List<ViewerAction> added) {
    for (ViewerAction action : added) {
      if (actions.containsKey(action.id())) {
        throw new IllegalArgumentException("there is an action " + action.id() + " already");
      }
      for (ViewerAction other : actions.values()) {
        if (!action.key().isEmpty() && other.key().equals(action.key())) {
          throw new IllegalArgumentException(
              action.key() + " is the key of " + other.id() + ", not of " + action.id());
        }
      }
      actions.put(action.id(), action);
    }
  }

  /** All of them, in the order in which they came. */
  List<ViewerAction> all() {
    return List.copyOf(actions.values());
  }

  /** The action of an id. */
  public Optional<ViewerAction> find(String id) {
    return Optional.ofNullable(actions.get(id));
  }

  /** Does what an id stands for. */
  public void run(String id) {
    run(find(id).orElseThrow(() -> new IllegalArgumentException("no action " + id)));
  }

  /** Does what an action stands for, or reports why it cannot be done now. */
  void run(ViewerAction action) {
    String obstacle = action.obstacle().get();
    if (obstacle.isEmpty()) {
      action.work().run();
    } else {
      refusals.accept(action.words() + ": " + obstacle);
    }
  }

  /** Reports commands that could not be done, with the reason. */
  public void onRefusal(Consumer<String> listener) {
    refusals = listener;
  }

  /** What stands in a menu, in order. */
  public List<ViewerAction> inMenu(String menu) {
    return actions.values().stream().filter(action -> action.menu().equals(menu)).toList();
  }

  /** Calls something after every change of what there is. */
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }
}
