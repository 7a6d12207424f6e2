package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import javafx.stage.Stage;

/** How window and events look. */
final class DisplayFeature implements ViewerFeature {
  private static final long[] DECAYS_US = {100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000};

  @Override
  public void install(ViewerContext window) {
    DisplayControl display = window.display();
    ViewerActions actions = window.actions();
    for (Theme theme : Theme.values()) {
      actions.add(
          ViewerAction.choice(
              "theme-" + theme.words().toLowerCase(java.util.Locale.ROOT),
              theme.words(),
              "View/Theme",
              display.themeProperty(),
              theme));
    }
    for (ColourMap map : ColourMap.all()) {
      actions.add(
          ViewerAction.choice(
              "colours-" + map.name().toLowerCase(java.util.Locale.ROOT).replace(' ', '-'),
              map.name(),
              "View/Colours of events",
              display.coloursProperty(),
              map));
    }
    actions.add(
        ViewerAction.choice(
            "fading-follows",
            "Follows the speed",
            "View/Fading",
            display.decayUsProperty(),
            DisplayOptions.FOLLOW_SLICES));
    for (long us : DECAYS_US) {
      actions.add(
          ViewerAction.choice(
              "fading-" + us, Texts.duration(us), "View/Fading", display.decayUsProperty(), us));
    }
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
}
