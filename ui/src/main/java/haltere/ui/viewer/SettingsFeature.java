package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.util.List;
import java.util.Map;
import javafx.application.Platform;
import javafx.stage.Stage;

/**
 * Keeps how a user has set up the window: colours, place and size, which panels are shown.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SettingsFeature implements ViewerFeature {
  private static final long BETWEEN_NANOS = 1_000_000_000;

  private long lookedNanos;

  @Override
  public void install(ViewerContext window) {
    UserSettings settings = window.settings();
    DisplayControl display = window.display();
    settings.keep(
        "theme",
        display.themeProperty(),
        Theme::words,
        words -> named(words, List.of(Theme.values()), Theme::words));
    settings.keep(
        "coloursOfPolarity",
        display.coloursProperty(),
        ColourMap::name,
        words -> named(words, ColourMap.all(), ColourMap::name));
    settings.keep(
        "coloursOfAgeAndCount",
        display.gradientProperty(),
        Gradient::name,
        words -> named(words, Gradient.all(), Gradient::name));
    settings.keep(
        "showAs",
        display.modeProperty(),
        DisplayMode::words,
        words -> named(words, List.of(DisplayMode.values()), DisplayMode::words));
    settings.keep("fadingUs", display.decayUsProperty(), us -> us, Long.class::cast);
    settings.keep("overlays", display.marksProperty());
    place(window.stage(), settings);
    window.panels().keepLayout(settings);
    window
        .panels()
        .onPulse(
            () -> {
              long nanos = System.nanoTime();
              if (nanos - lookedNanos > BETWEEN_NANOS && settings.hasChanged()) {
                lookedNanos = nanos;
                save(window);
              }
            });
  }

  private static void save(ViewerContext window) {
    window
        .background()
        .file(
            () -> {
              window.settings().save();
              return true;
            },
            saved -> {},
            problem -> window.status().showError(Texts.oneLine(problem)));
  }

  private static <T> T named(
      Object words, List<T> all, java.util.function.Function<T, String> name) {
    return all.stream().filter(one -> name.apply(one).equals(words)).findFirst().orElseThrow();
  }

  private static void place(Stage stage, UserSettings settings) {
    settings
        .get("window")
        .filter(Map.class::isInstance)
        .map(Map.class::cast)
        .ifPresent(kept -> place(stage, kept));
    Runnable keep =
        () -> {
          if (stage.isShowing()
              && !stage.isMaximized()
              && !stage.isFullScreen()
              && stage.getWidth() >= ViewerWindow.MIN_WIDTH
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
    // not while the stage is being shown, when its size comes in pieces
    stage.xProperty().addListener((property, was, is) -> Platform.runLater(keep));
    stage.yProperty().addListener((property, was, is) -> Platform.runLater(keep));
    stage.widthProperty().addListener((property, was, is) -> Platform.runLater(keep));
    stage.heightProperty().addListener((property, was, is) -> Platform.runLater(keep));
  }

  private static void place(Stage stage, Map<?, ?> kept) {
    if (kept.get("x") instanceof Number x
        && kept.get("y") instanceof Number y
        && kept.get("width") instanceof Number width
        && kept.get("height") instanceof Number height) {
      boolean onScreen =
          !javafx.stage.Screen.getScreensForRectangle(
                  x.doubleValue(), y.doubleValue(), width.doubleValue(), 60)
              .isEmpty();
      if (onScreen) {
        stage.setX(x.doubleValue());
        stage.setY(y.doubleValue());
      }
      stage.setWidth(Math.max(ViewerWindow.MIN_WIDTH, width.doubleValue()));
      stage.setHeight(Math.max(ViewerWindow.MIN_HEIGHT, height.doubleValue()));
    }
  }
}
