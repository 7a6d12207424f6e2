package haltere.ui.viewer.controls;

import javafx.scene.Node;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;

/**
 * A view in space. A drag or arrow keys rotate it; the wheel, plus and minus zoom; a double click
 * or Home restores the initial view.
 */
public abstract class RotatablePane extends KeyPane {
  private static final double DEGREES_PER_PIXEL = 0.5;
  private static final double DEGREES_PER_KEY = 5;
  private double pressedX;
  private double pressedY;

  /** A view with some nodes in it at first. */
  protected RotatablePane(Node... children) {
    super(children);
    setOnMousePressed(this::pressed);
    setOnMouseDragged(this::dragged);
    setOnKeyPressed(this::keyPressed);
    setOnScroll(
        event -> {
          zoom(Math.signum(event.getDeltaY()));
          event.consume();
        });
  }

  /** Rotates the view to the right and downwards. */
  protected abstract void turn(double rightDegrees, double downDegrees);

  /** Zooms by notches of the wheel, in if positive. */
  protected abstract void zoom(double notches);

  /** Goes back to the first view. */
  protected abstract void goBack();

  private void pressed(MouseEvent event) {
    requestFocus();
    pressedX = event.getX();
    pressedY = event.getY();
    if (event.getClickCount() == 2) {
      goBack();
    }
  }

  private void dragged(MouseEvent event) {
    turn(
        (event.getX() - pressedX) * DEGREES_PER_PIXEL,
        (event.getY() - pressedY) * DEGREES_PER_PIXEL);
    pressedX = event.getX();
    pressedY = event.getY();
  }

  private void keyPressed(KeyEvent event) {
    switch (event.getCode()) {
      case LEFT, KP_LEFT -> turn(-DEGREES_PER_KEY, 0);
      case RIGHT, KP_RIGHT -> turn(DEGREES_PER_KEY, 0);
      case UP, KP_UP -> turn(0, -DEGREES_PER_KEY);
      case DOWN, KP_DOWN -> turn(0, DEGREES_PER_KEY);
      case PLUS, ADD, EQUALS -> zoom(1);
      case MINUS, SUBTRACT -> zoom(-1);
      case HOME -> goBack();
      default -> {
        return;
      }
    }
    event.consume();
  }
}
