package haltere.ui.viewer;

import haltere.core.settings.Parameter;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.WindowFeature;
import java.util.List;
import java.util.function.Function;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.stage.Stage;

/** Appearance of window and events, chosen in menus and saved. */
final class DisplayFeature extends WindowFeature {
  @Override
  protected void install() {
    DisplayControl display = window.display();
    ViewerActions actions = window.actions();
    addLooks(display);
    BooleanProperty logarithmic = window.panels().seekBar().logarithmicProperty();
    window.settings().keep("logarithmicRate", logarithmic);
    window.settings().keep("overlays", display.marksProperty());
    actions.add("logarithmic-rate", logarithmic);
    actions.add("overlays", display.marksProperty());
    actions.add("show-all", () -> window.panels().view().viewpoint().showAll());
    Stage stage = window.stage();
    actions.add(
        "full-screen",
        stage.fullScreenProperty(),
        () -> stage.setFullScreen(!stage.isFullScreen()),
        () -> "");
  }

  /** Adds the choices of theme, display mode and colours. */
  private void addLooks(DisplayControl display) {
    offer(
        "theme", "Theme", "theme", display.themeProperty(), List.of(Theme.values()), Theme::label);
    ObjectProperty<DisplayMode> shown = display.modeProperty();
    for (DisplayMode mode : DisplayMode.values()) {
      String id = "show-as-" + Parameter.text(mode);
      window.actions().add(id, shown.isEqualTo(mode), () -> shown.set(mode), () -> "");
    }
    keep("showAs", shown, List.of(DisplayMode.values()), DisplayMode::label);
    offer(
        "colours",
        "Colours/Polarity",
        "coloursOfPolarity",
        display.coloursProperty(),
        ColourMap.all(),
        ColourMap::name);
    offer(
        "gradient",
        "Colours/Age and count",
        "coloursOfAgeAndCount",
        display.gradientProperty(),
        Gradient.all(),
        Gradient::name);
    window
        .actions()
        .addChoices(
            "fading-",
            "View/Fading",
            display.decayUsProperty(),
            DisplayControl.DECAYS.keySet(),
            DisplayControl.DECAYS::get);
    window.settings().keep("fadingUs", display.decayUsProperty(), us -> us, Long.class::cast);
  }

  /** Adds the values of a property to a menu, and saves the chosen one. */
  private <T> void offer(
      String id,
      String menu,
      String setting,
      ObjectProperty<T> property,
      List<T> values,
      Function<T, String> text) {
    window.actions().addChoices(id + "-", "View/" + menu, property, values, text);
    keep(setting, property, values, text);
  }

  private <T> void keep(
      String setting, ObjectProperty<T> property, List<T> values, Function<T, String> text) {
    window
        .settings()
        .keep(
            setting,
            property,
            text::apply,
            kept ->
                values.stream()
                    .filter(value -> text.apply(value).equals(kept))
                    .findFirst()
                    .orElseThrow());
  }
}
