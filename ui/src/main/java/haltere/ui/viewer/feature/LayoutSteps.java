package haltere.ui.viewer.feature;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.concurrent.Executor;
import javafx.application.Platform;
import javafx.scene.Scene;

/**
 * Makes a large change of the window in steps, so that none of them keeps its thread for long: the
 * window is laid out between one and the next, and does meanwhile what else there is to do.
 */
public final class LayoutSteps implements Executor {
  private final Scene scene;
  private final Queue<Runnable> steps = new ArrayDeque<>();

  /** Steps of a window with a scene, which it keeps. */
  public LayoutSteps(Scene scene) {
    this.scene = scene;
  }

  /**
   * Takes a step once the window has been laid out after those before it; while it is not on the
   * screen nobody waits for it, and the step is taken at once.
   */
  @Override
  public void execute(Runnable step) {
    if (isOnScreen() || !steps.isEmpty()) {
      afterLayout(step);
    } else {
      step.run();
    }
  }

  /** Takes a step once the window has been laid out, be it that it comes to the screen first. */
  public void afterLayout(Runnable step) {
    steps.add(step);
    if (steps.size() == 1) {
      awaitLayout();
    }
  }

  private boolean isOnScreen() {
    return scene.getWindow() != null && scene.getWindow().isShowing();
  }

  private void awaitLayout() {
    Runnable once =
        new Runnable() {
          @Override
          public void run() {
            scene.removePostLayoutPulseListener(this);
            // behind what has been asked for while the window was being laid out
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
