package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.util.Locale;
import javafx.beans.property.BooleanProperty;
import javafx.stage.Stage;

/** How window and events look. */
final class DisplayFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    DisplayControl display = window.display();
    ViewerActions actions = window.actions();
    for (Theme theme : Theme.values()) {
      actions.add(
          ViewerAction.choice(
              id("theme", theme.words()),
              theme.words(),
              "View/Theme",
              display.themeProperty(),
              theme));
    }
    addLooks(display, actions);
    BooleanProperty logarithmic = window.panels().seekBar().logarithmicProperty();
    window.settings().keep("logarithmicRate", logarithmic);
    actions.add(
        ViewerAction.toggle("logarithmic-rate", "Logarithmic rate", "View", logarithmic)
            .withHelp("Shows low rates beside high ones in the time bar."));
    Stage stage = window.stage();
    actions.add(
        ViewerAction.toggle("overlays", "Overlays", "View", display.marksProperty())
            .withKey("Shortcut+M")
            .withHelp("Shows what filters draw over the events."),
        ViewerAction.of("show-all", "Whole sensor", "View", () -> window.panels().view().showAll())
            .withKey("Shortcut+0"),
        ViewerAction.toggle(
                "full-screen",
                "Full screen",
                "View",
                stage.fullScreenProperty(),
                stage::setFullScreen)
            .withKey("F11"));
  }

  /** What the colour of a pixel says, which colours there are, and how they fade. */
  private static void addLooks(DisplayControl display, ViewerActions actions) {
    int number = 1;
    for (DisplayMode mode : DisplayMode.values()) {
      actions.add(
          ViewerAction.choice(
                  id("show-as", mode.words()),
                  mode.words(),
                  "View/Show as",
                  display.modeProperty(),
                  mode)
              .withKey("Shortcut+" + number++)
              .withHelp(mode.help()));
    }
    for (ColourMap map : ColourMap.all()) {
      actions.add(
          ViewerAction.choice(
              id("colours", map.name()),
              map.name(),
              "View/Colours of polarity",
              display.coloursProperty(),
              map));
    }
    for (Gradient gradient : Gradient.all()) {
      actions.add(
          ViewerAction.choice(
              id("gradient", gradient.name()),
              gradient.name(),
              "View/Colours of age and count",
              display.gradientProperty(),
              gradient));
    }
    DisplayControl.DECAYS.forEach(
        (us, words) ->
            actions.add(
                ViewerAction.choice(
                    "fading-" + us, words, "View/Fading", display.decayUsProperty(), us)));
  }

  private static String id(String group, String words) {
    return group + "-" + words.toLowerCase(Locale.ROOT).replace(' ', '-');
  }
}
