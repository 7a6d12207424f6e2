package haltere.ui.viewer;

import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.util.List;
import java.util.Map;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyDoubleProperty;
import javafx.stage.Screen;
import javafx.stage.Stage;

/** Saves position and size of the window and its panels, with the other settings. */
final class SettingsFeature implements ViewerFeature {
  private static final long BETWEEN_NANOS = 1_000_000_000;

  @Override
  public void install(ViewerContext window) {
    UserSettings settings = window.settings();
    place(window.stage(), settings);
    window.panels().panelLayout().keep(settings);
    window.panels().every(BETWEEN_NANOS, () -> save(window));
  }

  private static void save(ViewerContext window) {
    if (window.settings().hasChanged()) {
      window.background().file(window.settings()::save, () -> {}, window.status()::showProblem);
    }
  }

  private static void place(Stage stage, UserSettings settings) {
    place(stage, settings.map("window"));
    Runnable keep =
        () -> {
          if (stage.isShowing()
              && !stage.isMaximized()
              && !stage.isFullScreen()
              && stage.getWidth() > ViewerWindow.MIN_WIDTH
              && stage.getHeight() >= ViewerWindow.MIN_HEIGHT) {
            settings.put(
                "window",
                Map.of(
                    "x", Math.round(stage.getX()),
                    "y", Math.round(stage.getY()),
                    "width", Math.round(stage.getWidth()),
                    "height", Math.round(stage.getHeight())));
          }
        };
    // not during showing, when the size changes in steps, nor the least that a new window may get
    for (ReadOnlyDoubleProperty size :
        List.of(
            stage.xProperty(), stage.yProperty(), stage.widthProperty(), stage.heightProperty())) {
      size.subscribe((was, is) -> Platform.runLater(keep));
    }
  }

  private static void place(Stage stage, Map<?, ?> kept) {
    if (kept.get("x") instanceof Number x
        && kept.get("y") instanceof Number y
        && kept.get("width") instanceof Number width
        && kept.get("height") instanceof Number height) {
      if (!Screen.getScreensForRectangle(x.doubleValue(), y.doubleValue(), width.doubleValue(), 60)
          .isEmpty()) {
        stage.setX(x.doubleValue());
        stage.setY(y.doubleValue());
      }
      stage.setWidth(Math.max(ViewerWindow.MIN_WIDTH, width.doubleValue()));
      stage.setHeight(Math.max(ViewerWindow.MIN_HEIGHT, height.doubleValue()));
    }
  }
}
