package haltere.ui.viewer;

import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.ComboBoxBase;
import javafx.scene.control.Slider;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;

/**
 * The keys of playback. They work wherever the focus is, but for entries of text; arrow keys also
 * belong to sliders and lists. Since Space is pause, Enter presses the button that has the focus.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ViewerKeys {
  private static final long JUMP_US = 1_000_000;
  private static final int JOG_SLICES = 20;

  private final PlaybackController playback;

  private ViewerKeys(PlaybackController playback) {
    this.playback = playback;
  }

  /** Listens to the keys of a window. */
  static void install(Scene scene, PlaybackController playback) {
    ViewerKeys keys = new ViewerKeys(playback);
    scene.addEventFilter(
        KeyEvent.KEY_PRESSED,
        event -> {
          if (keys.handle(event, scene.getFocusOwner())) {
            event.consume();
          }
        });
    // a button fires when Space is released
    scene.addEventFilter(
        KeyEvent.KEY_RELEASED,
        event -> {
          if (event.getCode() == KeyCode.SPACE
              && !(scene.getFocusOwner() instanceof TextInputControl)) {
            event.consume();
          }
        });
  }

  private boolean handle(KeyEvent event, Node focus) {
    if (event.isControlDown() || event.isAltDown() || event.isMetaDown()) {
      return false;
    }
    if (focus instanceof TextInputControl) {
      return false;
    }
    if (event.getCode() == KeyCode.ENTER && focus instanceof ButtonBase button) {
      button.fire();
      return true;
    }
    boolean ownsArrows =
        focus instanceof Slider
            || focus instanceof ChoiceBox<?>
            || focus instanceof ComboBoxBase<?>;
    return switch (event.getCode()) {
      case LEFT, RIGHT, UP, DOWN, HOME, END -> !ownsArrows && arrow(event);
      default -> letter(event);
    };
  }

  private boolean arrow(KeyEvent event) {
    long way = event.isShiftDown() ? 10 * JUMP_US : JUMP_US;
    switch (event.getCode()) {
      case LEFT -> playback.jump(-way);
      case RIGHT -> playback.jump(way);
      case HOME -> playback.seek(0);
      case END -> playback.seek(Long.MAX_VALUE);
      default -> {
        return false;
      }
    }
    return true;
  }

  private boolean letter(KeyEvent event) {
    int slices = event.isShiftDown() ? JOG_SLICES : 1;
    switch (event.getCode()) {
      case SPACE -> playback.togglePause();
      case PERIOD, GREATER -> playback.step(slices);
      case COMMA, LESS -> playback.step(-slices);
      case F -> playback.faster();
      case S -> playback.slower();
      case R -> playback.rewind();
      case I -> playback.markIn();
      case O -> playback.markOut();
      case M -> playback.mark();
      case J -> playback.toMark(false);
      case K -> playback.toMark(true);
      case L -> playback.setLooping(!playback.loopProperty().get().on());
      case Z -> playback.reset();
      default -> {
        return false;
      }
    }
    return true;
  }
}
