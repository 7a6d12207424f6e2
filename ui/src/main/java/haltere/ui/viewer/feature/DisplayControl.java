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
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.DoubleProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleDoubleProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.value.ObservableValue;

/**
 * The chosen appearance of window and events, observed by the views.
 *
 * @param themeProperty the theme; a change sets its default colours
 * @param coloursProperty the colours of polarities
 * @param decayUsProperty as {@link DisplayOptions#decayUs()}
 * @param modeProperty meaning of the colour of a pixel
 * @param gradientProperty the colours of ages and counts
 * @param marksProperty whether marks of the filters are drawn over the events
 * @param framesProperty whether the camera's frames are drawn below the events
 * @param frameOpacityProperty how much of a frame is seen: 0 nothing, 1 all of it
 * @param allEventsProperty whether events before the filters are shown
 * @param regionProperty the region of interest
 * @param tapeProperty the measured line
 */
public record DisplayControl(
    ObjectProperty<Theme> themeProperty,
    ObjectProperty<ColourMap> coloursProperty,
    ObjectProperty<Long> decayUsProperty,
    ObjectProperty<DisplayMode> modeProperty,
    ObjectProperty<Gradient> gradientProperty,
    BooleanProperty marksProperty,
    BooleanProperty framesProperty,
    DoubleProperty frameOpacityProperty,
    BooleanProperty allEventsProperty,
    ObjectProperty<Optional<PixelRegion>> regionProperty,
    ObjectProperty<Optional<MeasuredLine>> tapeProperty) {
  /** Offered time constants of fading, and their labels. */
  public static final Map<Long, String> DECAYS = decays();

  /** Looks as in a new window. */
  public DisplayControl() {
    this(
        new SimpleObjectProperty<>(Theme.DARK),
        new SimpleObjectProperty<>(DisplayOptions.DEFAULT.colours()),
        new SimpleObjectProperty<>(DisplayOptions.DEFAULT.decayUs()),
        new SimpleObjectProperty<>(DisplayOptions.DEFAULT.mode()),
        new SimpleObjectProperty<>(DisplayOptions.DEFAULT.gradient()),
        new SimpleBooleanProperty(true),
        new SimpleBooleanProperty(true),
        new SimpleDoubleProperty(DisplayOptions.DEFAULT.frameOpacity()),
        new SimpleBooleanProperty(),
        new SimpleObjectProperty<>(Optional.empty()),
        new SimpleObjectProperty<>(Optional.empty()));
    themeProperty.subscribe((was, is) -> coloursProperty.set(is.colours()));
  }

  private static Map<Long, String> decays() {
    Map<Long, String> decays = new LinkedHashMap<>();
    decays.put(DisplayOptions.FOLLOW_SLICES, "Follow the speed");
    decays.put(DisplayOptions.SLICE_ONLY, "Last slice only");
    decays.put(DisplayOptions.ACCUMULATE, "None: accumulate");
    for (long us : new long[] {100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000}) {
      decays.put(us, Texts.duration(us).replaceFirst("\\.0+ ", " "));
    }
    return Collections.unmodifiableMap(decays);
  }

  /** The overlays over the events. */
  public Overlays overlays() {
    return new Overlays(marksProperty.get(), regionProperty.get(), tapeProperty.get());
  }

  /** The options of the painter. */
  public DisplayOptions options() {
    return new DisplayOptions(
        modeProperty.get(),
        coloursProperty.get(),
        gradientProperty.get(),
        decayUsProperty.get(),
        framesProperty.get() ? frameOpacityProperty.get() : 0);
  }

  /** Adds a listener to changes of {@link #options()}. */
  public void onChange(Runnable listener) {
    for (ObservableValue<?> shown :
        List.of(
            coloursProperty,
            modeProperty,
            gradientProperty,
            decayUsProperty,
            framesProperty,
            frameOpacityProperty)) {
      shown.subscribe((was, is) -> listener.run());
    }
  }
}
