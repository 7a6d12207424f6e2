package haltere.ui.viewer.feature;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.Executor;
import javafx.application.Platform;
import javafx.scene.Scene;

/**
 * Runs a large change of the window in steps, with a layout and other tasks between them, so that
 * no step blocks the thread for long.
 */
public final class LayoutSteps implements Executor {
  private final Scene scene;
  private final Queue<Runnable> steps = new ArrayDeque<>();

  /** Steps of a window with a scene. */
  public LayoutSteps(Scene scene) {
    this.scene = scene;
  }

  /**
   * Runs a step after the layout that follows earlier steps; at once while the window is not on the
   * screen.
   */
  @Override
  public void execute(Runnable step) {
    if (scene.getWindow() != null && scene.getWindow().isShowing() || !steps.isEmpty()) {
      afterLayout(step);
    } else {
      step.run();
    }
  }

  /** Runs a step after the next layout, or first appearance, of the window. */
  public void afterLayout(Runnable step) {
    steps.add(step);
    if (steps.size() == 1) {
      awaitLayout();
    }
  }

  private void awaitLayout() {
    Runnable once =
        new Runnable() {
          @Override
          public void run() {
            scene.removePostLayoutPulseListener(this);
            // after tasks queued during the layout
            Platform.runLater(LayoutSteps.this::next);
          }
        };
    scene.addPostLayoutPulseListener(once);
    Platform.requestNextPulse();
  }

  private void next() {
    try {
      steps.element().run();
    } finally {
      steps.remove();
      if (!steps.isEmpty()) {
        awaitLayout();
      }
    }
  }
}
