package haltere.ui.viewer.controls;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import haltere.ui.rendering.ColourMap;
import javafx.application.Application;
import javafx.scene.paint.Color;

/** The colour theme of the window. */
public enum Theme {
  DARK("Dark", ColourMap.DARK),
  LIGHT("Light", ColourMap.LIGHT);

  private final String label;
  private final ColourMap colours;

  Theme(String label, ColourMap colours) {
    this.label = label;
    this.colours = colours;
  }

  /** Label in menus. */
  public String label() {
    return label;
  }

  /** The colours of events that go with it. */
  public ColourMap colours() {
    return colours;
  }

  /** An ARGB colour as JavaFX knows it. */
  public static Color colour(int argb) {
    return Color.rgb(argb >> 16 & 0xFF, argb >> 8 & 0xFF, argb & 0xFF, (argb >>> 24) / 255.0);
  }

  /** Makes it the style of all windows. */
  public void apply() {
    Application.setUserAgentStylesheet(
        (this == DARK ? new PrimerDark() : new PrimerLight()).getUserAgentStylesheet());
  }
}
