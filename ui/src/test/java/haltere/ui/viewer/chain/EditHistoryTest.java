package haltere.ui.viewer.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Undo and redo. */
class EditHistoryTest {
  private final EditHistory history = new EditHistory();
  private int value;

  private void set(int newValue, double seconds) {
    int before = value;
    value = newValue;
    history.made(
        "the value",
        this,
        "value",
        () -> value = before,
        () -> value = newValue,
        Math.round(seconds * 1e9));
  }

  @Test
  void changesAreUndoneAndRedone() {
    set(1, 0);
    set(2, 10);
    assertEquals("the value", history.undo());
    assertEquals(1, value);
    history.undo();
    assertEquals(0, value);
    assertEquals("", history.undo());
    history.redo();
    history.redo();
    assertEquals(2, value);
    assertEquals("", history.redo());
  }

  @Test
  void changesInQuickSuccessionAreOneStep() {
    for (int i = 1; i <= 30; i++) {
      set(i, i * 0.05);
    }
    history.undo();
    assertEquals(0, value);
    history.redo();
    assertEquals(30, value);
  }

  @Test
  void newChangeDiscardsUndoneChanges() {
    set(1, 0);
    history.undo();
    set(5, 20);
    assertEquals("", history.redo());
    assertEquals(5, value);
  }

  @Test
  void rejectedChangeIsNeitherUndoneNorRedone() {
    set(1, 0);
    Object refused = new Object();
    history.made("refused", this, refused, () -> value = -1, () -> value = -2, 10_000_000_000L);
    history.remove(refused);
    assertEquals("the value", history.undo());
    assertEquals(0, value);
    history.made("refused", this, refused, () -> value = -1, () -> value = -2, 20_000_000_000L);
    history.undo();
    history.remove(refused);
    assertEquals("", history.redo());
  }
}
