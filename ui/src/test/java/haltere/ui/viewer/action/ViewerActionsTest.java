package haltere.ui.viewer.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.ui.viewer.ViewerHarness;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.Test;

/** What a person can do, and how it is found. */
class ViewerActionsTest {
  private final List<String> done = new ArrayList<>();

  private ViewerAction action(String id, String text) {
    return ViewerAction.of(id, text, "Tools", () -> done.add(id));
  }

  private ViewerAction keyed(String id, String key) {
    return new ViewerAction(
        id, id, "Tools", key, "", () -> done.add(id), Optional.empty(), () -> "");
  }

  private static List<String> found(ViewerActions actions, String typed) {
    return CommandPalette.matches(actions.all(), typed).stream().map(ViewerAction::id).toList();
  }

  @Test
  void actionRunsByItsId() {
    ViewerActions actions = new ViewerActions();
    actions.add(action("one", "First"), action("two", "Second"));
    actions.run("two");
    assertEquals(List.of("two"), done);
    assertThrows(IllegalArgumentException.class, () -> actions.run("three"));
  }

  @Test
  void duplicateIdsAndKeysAreRejected() {
    ViewerActions actions = new ViewerActions();
    actions.add(keyed("one", "X"));
    assertThrows(IllegalArgumentException.class, () -> actions.add(action("one", "Again")));
    IllegalArgumentException problem =
        assertThrows(IllegalArgumentException.class, () -> actions.add(keyed("two", "X")));
    assertEquals("X is the key of one, not of two", problem.getMessage());
  }

  @Test
  void actionIsFoundByWordsInAnyOrder() {
    ViewerActions actions = new ViewerActions();
    actions.add(
        action("save", "Save the chain").withHelp("Writes a file."),
        action("load", "Load a chain"));
    assertEquals(List.of("save", "load"), found(actions, ""));
    assertEquals(List.of("save"), found(actions, "chain SAVE"));
    assertEquals(List.of("save"), found(actions, "writes"));
    assertEquals(List.of("load", "save"), found(actions, "l"), "what begins so comes first");
    assertEquals(List.of(), found(actions, "nonsense"));
  }

  @Test
  void keysOfEntriesAreNotPlainOnes() {
    assertTrue(keyed("a", "Space").hasPlainKey());
    assertTrue(keyed("a", "Shift+Comma").hasPlainKey());
    assertFalse(keyed("a", "Shortcut+O").hasPlainKey());
    assertFalse(keyed("a", "F11").hasPlainKey());
    assertFalse(action("a", "A").hasPlainKey());
    assertEquals("Shift+,", ViewerKeys.label("Shift+Comma"));
  }

  @Test
  void paletteRunsTheFoundAction() {
    try (ViewerHarness viewer = ViewerHarness.withBlob()) {
      viewer.press(KeyCode.CONTROL, KeyCode.K);
      viewer.waitFor("the palette", () -> viewer.isThere("palette-search"));
      TextField search = viewer.node("palette-search", TextField.class);
      viewer.waitFor("the focus", search::isFocused);
      viewer.run(() -> search.setText("overlays"));
      assertTrue(viewer.onFx(() -> viewer.window.context().display().marksProperty().get()));
      viewer.press(KeyCode.ENTER);
      viewer.waitFor("no overlays", () -> !viewer.window.context().display().marksProperty().get());
      viewer.waitFor("the palette is gone", () -> !viewer.isThere("palette-search"));
    }
  }
}
