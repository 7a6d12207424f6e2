package haltere.ui.viewer.chain;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.controls.Controls;
import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.VBox;
import javafx.scene.text.TextAlignment;

/**
 * The buttons of the usual filters, one below the other beside the picture.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class FilterStrip extends VBox {
  private final Map<UsualFilter, ToggleButton> buttons = new EnumMap<>(UsualFilter.class);

  /** Buttons that are off, and tell which one was pressed. */
  public FilterStrip(Consumer<UsualFilter> pressed) {
    setId("filter-strip");
    getStyleClass().add("filter-strip");
    for (UsualFilter filter : UsualFilter.values()) {
      ToggleButton button = Controls.toggle(id(filter), filter.icon(), filter.help());
      button.setText(filter.words().replace(' ', '\n'));
      button.setTextAlignment(TextAlignment.CENTER);
      button.setContentDisplay(ContentDisplay.TOP);
      button.setMaxWidth(Double.MAX_VALUE);
      button.getStyleClass().remove(Styles.BUTTON_ICON);
      button.setAccessibleText(filter.words());
      button.setOnAction(
          event -> {
            // on once the chain has the filter
            button.setSelected(!button.isSelected());
            pressed.accept(filter);
          });
      buttons.put(filter, button);
      getChildren().add(button);
    }
  }

  /** The id of a filter's button. */
  public static String id(UsualFilter filter) {
    return "usual-" + filter.name().toLowerCase(Locale.ROOT);
  }

  /** Shows whether a filter is on. */
  public void show(UsualFilter filter, boolean on) {
    buttons.get(filter).setSelected(on);
  }
}
