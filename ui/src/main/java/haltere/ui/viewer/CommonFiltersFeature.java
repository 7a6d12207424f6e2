package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import haltere.core.chain.FilterChain;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.chain.CommonFilter;
import haltere.ui.viewer.chain.StageState;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.HiddenEvents;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.value.ObservableValue;
import javafx.geometry.Pos;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.scene.text.TextAlignment;

/**
 * The common filters: their buttons beside the picture, the default chain of the open source, and a
 * note below them on the events that filters hide.
 */
final class CommonFiltersFeature extends WindowFeature {
  /** Minimum height, pixels, for buttons with text and the note. */
  private static final double WORDS_PX = 235;

  private static final double ICONS_PX = 112;

  private final Map<CommonFilter, BooleanProperty> on = new EnumMap<>(CommonFilter.class);
  private final Label note =
      Controls.named(Controls.paragraph("", "readout"), "filter-status", "filter-status");
  private HiddenEvents hidden;
  private List<StageState> stages = List.of();

  @Override
  protected void install() {
    BooleanProperty all = window.display().allEventsProperty();
    hidden = new HiddenEvents(all);
    VBox strip = Controls.named(new VBox(), "filter-strip", "filter-strip");
    strip.setMinHeight(ICONS_PX);
    ObservableValue<ContentDisplay> text =
        strip
            .heightProperty()
            .map(
                high ->
                    high.doubleValue() < WORDS_PX
                        ? ContentDisplay.GRAPHIC_ONLY
                        : ContentDisplay.TOP);
    window.panels().addBesidePicture(strip);
    note.setMaxSize(Region.USE_PREF_SIZE, Region.USE_PREF_SIZE);
    window.panels().addOverPicture(note, Pos.TOP_LEFT);
    for (CommonFilter filter : CommonFilter.values()) {
      BooleanProperty property = new SimpleBooleanProperty();
      on.put(filter, property);
      window.actions().add(filter.id(), property, () -> toggle(filter), window::nothingOpen);
      ToggleButton button = button(filter, property);
      button.contentDisplayProperty().bind(text);
      strip.getChildren().add(button);
    }
    strip.getChildren().add(hidden);
    window.actions().add("usual-chain", this::defaultChain, window::nothingOpen);
    window.actions().add("all-events", all);
    window.editor().onChange(() -> window.read(StageState::of, this::follow));
    window.onSession(
        made -> {
          all.set(false);
          hidden.clear();
          follow(made.firstStages());
        });
    // a card switches its filter without a message
    window.panels().onPulse(this::showSwitches);
    window.panels().every(HiddenEvents.BETWEEN_NANOS, this::measure);
  }

  /** The button of a filter, selected while the filter is enabled in the chain. */
  private ToggleButton button(CommonFilter filter, BooleanProperty property) {
    ViewerAction command = window.actions().find(filter.id()).orElseThrow();
    ToggleButton button = Controls.toggle(filter.id(), filter.icon(), command.help());
    button.setText(command.label().replace(' ', '\n'));
    button.setTextAlignment(TextAlignment.CENTER);
    button.setMaxWidth(Double.MAX_VALUE);
    button.getStyleClass().remove(Styles.BUTTON_ICON);
    button.setAccessibleText(command.label());
    property.subscribe((was, is) -> button.setSelected(is));
    button.setOnAction(
        event -> {
          button.setSelected(property.get());
          toggle(filter);
        });
    return button;
  }

  private void follow(List<StageState> newStages) {
    stages = newStages;
    showSwitches();
  }

  private void showSwitches() {
    on.forEach((filter, property) -> property.set(filter.isOn(stages)));
  }

  private void toggle(CommonFilter filter) {
    String text = ViewerActions.label(filter.id());
    window.editor().setCommonFilter(filter, text, !on.get(filter).get());
  }

  private void defaultChain() {
    window.ifOpen(
        open ->
            window
                .editor()
                .replaceAll(open.request().start().defaultChain(open.chain().geometry())));
  }

  private void measure() {
    window.ifOpen(open -> hidden.update(open.display()));
    window.read(FilterChain::status, this::showStatus);
  }

  private void showStatus(String status) {
    note.setText(status);
    Controls.show(!status.isEmpty(), note);
  }
}
