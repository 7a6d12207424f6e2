package haltere.ui.viewer.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.feature.DisplayControl;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javafx.scene.control.ContextMenu;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCombination;
import javafx.stage.Window;
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
  void offeredActionsKeepTheirPlaceWhenTheyAreReplaced() {
    ViewerActions actions = new ViewerActions();
    actions.add(action("first", "First"));
    actions.offer("files", List.of());
    actions.add(action("last", "Last"));
    actions.offer("files", List.of(action("a", "A")));
    actions.offer("files", List.of(action("b", "B"), action("a", "A")));
    assertEquals(
        List.of("first", "b", "a", "last"), actions.all().stream().map(ViewerAction::id).toList());
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
  void actionOfTheTypedNameComesBeforeThoseThatAreDescribedByIt() {
    ViewerActions actions = new ViewerActions();
    actions.add(
        action("scene", "Fly scene").withHelp("Wings, and a logarithm of light."),
        action("log", "Log of wings"));
    assertEquals(List.of("log", "scene"), found(actions, "log wings"));
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

  @Test
  void paletteSaysThatNoCommandMatches() {
    try (ViewerHarness viewer = ViewerHarness.withBlob()) {
      viewer.press(KeyCode.CONTROL, KeyCode.K);
      viewer.waitFor("the palette", () -> viewer.isThere("palette-search"));
      TextField search = viewer.node("palette-search", TextField.class);
      viewer.run(() -> search.setText("no such command"));
      ListView<?> list = viewer.node("palette-list", ListView.class);
      viewer.waitFor("no command", () -> list.getItems().isEmpty());
      Label words = (Label) viewer.onFx(list::getPlaceholder);
      assertEquals("No command matches.", words.getText());
      viewer.press(KeyCode.ESCAPE);
    }
  }

  @Test
  void actionThatCannotBeDoneIsRefusedWithTheReason() {
    ViewerActions actions = new ViewerActions();
    List<String> refusals = new ArrayList<>();
    actions.onRefusal(refusals::add);
    actions.add("undo", () -> done.add("undo"), () -> "nothing was changed");
    actions.run("undo");
    assertEquals(List.of(), done);
    assertEquals(List.of("Undo: nothing was changed"), refusals);
    actions.add("redo", () -> done.add("redo"));
    actions.run("redo");
    assertEquals(List.of("redo"), done);
    assertEquals("", refusals.get(1), "the refusal is over");
  }

  /** JavaFX passes no key on to an item that is disabled. */
  @Test
  void keyOfACommandWorksAfterItsMenuShowedThatItCouldNotBeDone() {
    try (ViewerHarness viewer = ViewerHarness.withBlob()) {
      ViewerMenu bar = viewer.node("menu", ViewerMenu.class);
      Menu edit = viewer.onFx(() -> bar.getMenus().get(1));
      viewer.run(edit::show);
      viewer.waitFor("Undo is disabled", () -> edit.getItems().get(0).isDisable());
      viewer.run(edit::hide);
      viewer.waitFor("the menu is closed", () -> !edit.isShowing());
      viewer.addNoiseFilters();
      viewer.press(KeyCode.CONTROL, KeyCode.Z);
      viewer.waitFor("it is undone", () -> viewer.text("status-message").startsWith("Undone"));
      viewer.press(KeyCode.ESCAPE);
      viewer.waitFor("no message", () -> viewer.text("status-message").startsWith("blob"));
    }
  }

  @Test
  void fadingTimesAreRoundNumbers() {
    assertEquals("1 ms", DisplayControl.DECAYS.get(1_000L));
    assertEquals("300 ms", DisplayControl.DECAYS.get(300_000L));
  }

  @Test
  void everyMenuOfAnActionIsInTheBar() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      MenuBar bar = viewer.node("menu", MenuBar.class);
      List<String> shown =
          viewer.onFx(
              () -> bar.getMenus().stream().map(menu -> menu.getText().substring(1)).toList());
      List<String> wanted =
          viewer.onFx(
              () ->
                  viewer.window.context().actions().all().stream()
                      .map(action -> action.menu().split("/")[0])
                      .filter(menu -> !menu.isEmpty())
                      .toList());
      assertEquals(Set.copyOf(wanted), Set.copyOf(shown));
      assertEquals("Help", shown.get(shown.size() - 1));
    }
  }

  @Test
  void keysWithoutModifiersDoNotReplaceOneAnotherInTheMenus() {
    try (ViewerHarness viewer = new ViewerHarness()) {
      List<String> plain =
          viewer.onFx(
              () ->
                  viewer.window.context().actions().all().stream()
                      .filter(ViewerAction::hasPlainKey)
                      .map(action -> ViewerKeys.label(action.key()))
                      .toList());
      assertTrue(plain.size() > 1);
      viewer.waitFor(
          "each key",
          () ->
              viewer.stage.getScene().getAccelerators().keySet().stream()
                  .map(KeyCombination::getDisplayText)
                  .toList()
                  .containsAll(plain));
    }
  }

  @Test
  void everyMenuFitsBelowItsBarOnAScreenOf700Pixels() {
    try (ViewerHarness viewer = ViewerHarness.withBlob()) {
      ViewerMenu bar = viewer.node("menu", ViewerMenu.class);
      for (Menu menu : viewer.onFx(() -> List.copyOf(bar.getMenus()))) {
        viewer.run(menu::show);
        viewer.waitFor(menu.getText(), () -> height() > 0);
        double height = viewer.onFx(ViewerActionsTest::height);
        assertTrue(height < 640, menu.getText() + " is " + height + " pixels high");
        viewer.run(menu::hide);
        viewer.waitFor("it is closed", () -> height() == 0);
      }
    }
  }

  /** Height of the menu that is open. */
  private static double height() {
    return Window.getWindows().stream()
        .filter(ContextMenu.class::isInstance)
        .mapToDouble(Window::getHeight)
        .sum();
  }
}
