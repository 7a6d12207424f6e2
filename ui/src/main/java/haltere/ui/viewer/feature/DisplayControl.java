package haltere.ui.viewer.feature;

import haltere.filters.frequency.PixelRegion;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.MeasuredLine;
import haltere.ui.viewer.picture.Overlays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;

/**
 * How window and events look, as a person has chosen; whoever shows them listens.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class DisplayControl {
  /** Time constants of the fading that are offered, and what a menu calls them. */
  public static final Map<Long, String> DECAYS = decays();

  private final ObjectProperty<Theme> theme = new SimpleObjectProperty<>(Theme.DARK);
  private final ObjectProperty<ColourMap> colours =
      new SimpleObjectProperty<>(DisplayOptions.DEFAULT.colours());
  private final ObjectProperty<Long> decayUs =
      new SimpleObjectProperty<>(DisplayOptions.DEFAULT.decayUs());
  private final ObjectProperty<DisplayMode> mode =
      new SimpleObjectProperty<>(DisplayOptions.DEFAULT.mode());
  private final ObjectProperty<Gradient> gradient =
      new SimpleObjectProperty<>(DisplayOptions.DEFAULT.gradient());
  private final BooleanProperty marks = new SimpleBooleanProperty(true);
  private final BooleanProperty frames = new SimpleBooleanProperty(true);
  private final DoubleProperty frameOpacity = new SimpleDoubleProperty(0.6);
  private final BooleanProperty allEvents = new SimpleBooleanProperty();
  private final ObjectProperty<Optional<PixelRegion>> region =
      new SimpleObjectProperty<>(Optional.empty());
  private final ObjectProperty<Optional<MeasuredLine>> tape =
      new SimpleObjectProperty<>(Optional.empty());

  private static Map<Long, String> decays() {
    Map<Long, String> decays = new LinkedHashMap<>();
    decays.put(DisplayOptions.FOLLOW_SLICES, "Follow the speed");
    decays.put(DisplayOptions.SLICE_ONLY, "Last slice only");
    decays.put(DisplayOptions.ACCUMULATE, "None: accumulate");
    for (long us : new long[] {100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000}) {
      decays.put(us, Texts.duration(us));
    }
    return Collections.unmodifiableMap(decays);
  }

  /** Looks as in a new window. */
  public DisplayControl() {
    // a theme brings the colours that go with it
    theme.subscribe((was, is) -> colours.set(is.colours()));
  }

  /** How the window looks; a change brings the colours that go with it. */
  public ObjectProperty<Theme> themeProperty() {
    return theme;
  }

  /** The colours of polarities. */
  public ObjectProperty<ColourMap> coloursProperty() {
    return colours;
  }

  /** What the colour of a pixel says about its events. */
  public ObjectProperty<DisplayMode> modeProperty() {
    return mode;
  }

  /** The colours of ages and counts. */
  public ObjectProperty<Gradient> gradientProperty() {
    return gradient;
  }

  /** As {@link DisplayOptions#decayUs()}. */
  public ObjectProperty<Long> decayUsProperty() {
    return decayUs;
  }

  /** Whether marks of the filters are drawn over the events. */
  public BooleanProperty marksProperty() {
    return marks;
  }

  /** Whether the camera's frames are drawn below the events. */
  public BooleanProperty framesProperty() {
    return frames;
  }

  /** How much of a frame is seen: 0 nothing, 1 all of it. */
  public DoubleProperty frameOpacityProperty() {
    return frameOpacity;
  }

  /** Whether events are shown as they come, before the filters. */
  public BooleanProperty allEventsProperty() {
    return allEvents;
  }

  /** The region of interest. */
  public ObjectProperty<Optional<PixelRegion>> regionProperty() {
    return region;
  }

  /** What was measured. */
  public ObjectProperty<Optional<MeasuredLine>> tapeProperty() {
    return tape;
  }

  /** What lies over the events. */
  public Overlays overlays() {
    return new Overlays(marks.get(), region.get(), tape.get());
  }

  /** What the painter of events needs to know. */
  public DisplayOptions options() {
    return new DisplayOptions(mode.get(), colours.get(), gradient.get(), decayUs.get());
  }

  /** Calls something after each change of {@link #options()}. */
  public void onChange(Runnable listener) {
    colours.subscribe((was, is) -> listener.run());
    mode.subscribe((was, is) -> listener.run());
    gradient.subscribe((was, is) -> listener.run());
    decayUs.subscribe((was, is) -> listener.run());
  }
}
