package haltere.ui.viewer.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.playback.ScenePlayable;
import haltere.testing.Recorded;
import haltere.ui.plot.PlotField;
import haltere.ui.viewer.BlobSource;
import haltere.ui.viewer.PresetFeature;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.EditHistory;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.picture.EventView;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import javafx.geometry.Bounds;
import javafx.geometry.Dimension2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuButton;
import javafx.scene.layout.Region;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two chains side by side, and presets, in the real window. */
class CompareTest {
  @TempDir Path folder;
  private ViewerHarness viewer;

  @AfterEach
  void close() {
    if (viewer != null) {
      viewer.close();
    }
  }

  private CompareFeature compare() {
    return viewer.window.feature(CompareFeature.class);
  }

  @Test
  void secondChainIsAnIndependentCopy() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("the second chain", () -> compare().secondChain().isPresent());
    FilterChain second = viewer.onFx(() -> compare().secondChain().orElseThrow());
    FilterChain first = viewer.session().chain();
    assertEquals(names(first), names(second));
    ChainStage tracker = second.stages().get(0);
    viewer.waitFor("events through it", () -> tracker.timing().eventsIn() > 0);
    viewer.waitFor("its own settings", () -> viewer.isThere("second-chain-panel"));
    viewer.waitFor("numbers", () -> viewer.isThere("comparison"));
    viewer.waitFor(
        "the name of the first",
        () ->
            viewer
                .text("first-chain-name")
                .equals("First chain: Background activity, Hot pixels, Object tracker"));
    viewer.run(() -> compare().editor().remove(second.stages().get(0)));
    viewer.waitFor(
        "the name of the second",
        () -> viewer.text("second-chain-name").equals("Second chain: Hot pixels, Object tracker"));
    viewer.waitFor("the second is shorter", () -> second.stages().size() == 2);
    assertEquals(3, first.stages().size());
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("the second is as before", () -> names(first).equals(names(second)));
    viewer.run(() -> viewer.window.context().actions().run("redo"));
    viewer.waitFor("the second is shorter again", () -> second.stages().size() == 2);
    viewer.run(() -> viewer.window.context().editor().remove(first.stages().get(2)));
    viewer.waitFor("a change of the first", () -> first.stages().size() == 2);
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("one chain again", () -> !viewer.isThere("second-event-view"));
    assertTrue(viewer.onFx(() -> compare().secondChain().isEmpty()));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("the first as before", () -> first.stages().size() == 3);
    EditHistory history = viewer.window.context().editor().history();
    assertNotEquals(
        "removing Background activity",
        viewer.onFx(history::undo),
        "changes of the second chain have ended with it");
  }

  @Test
  void comparisonNeedsAnOpenSource() throws Exception {
    viewer = new ViewerHarness();
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor(
        "the reason",
        () -> viewer.text("status-message").equals("Compare with a second chain: nothing is open"));
    Node button = viewer.node("tool-compare", Node.class);
    assertTrue(viewer.onFx(button::isDisabled));
    assertEquals("nothing is open", viewer.onFx(() -> Controls.help(button.getParent())));
    viewer.openRecording(ViewerHarness.recording(folder, "blob.aedat"));
    viewer.waitFor("an enabled button", () -> !button.isDisabled());
  }

  @Test
  void identicalChainsShowNoDifference() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    viewer.waitFor("a track", () -> viewer.status().elapsedUs() > 300_000);
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("the second chain", () -> compare().secondChain().isPresent());
    viewer.waitFor(
        "pictures of the same size",
        () ->
            viewer.isThere("event-view")
                && viewer.isThere("second-event-view")
                && size("event-view").equals(size("second-event-view")));
    for (int i = 0; i < 3; i++) {
      Set<String> before = tableTexts();
      viewer.waitFor(
          "other numbers", () -> tableTexts().contains("same") && !tableTexts().equals(before));
      Set<String> texts = tableTexts();
      assertTrue(texts.stream().noneMatch(text -> text.endsWith("%")), texts.toString());
    }
  }

  @Test
  void numbersInAPauseAreThoseOfItsMoment() throws Exception {
    viewer = ViewerHarness.withRecording(folder, 2_000_000);
    viewer.pause();
    viewer.session().player().seek(1_000_000).join();
    viewer.click("usual-objects");
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("the table", () -> viewer.isThere("comparison"));
    viewer.waitFor("numbers of this moment", () -> tableTexts().contains("same"));
    Set<String> here = tableTexts();
    viewer.session().player().seek(1_800_000).join();
    viewer.waitFor("other numbers", () -> !tableTexts().equals(here));
  }

  @Test
  void bothPicturesShowTheSameMomentDuringPlayback() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("the second picture", () -> viewer.isThere("second-event-view"));
    EventView first = viewer.node("event-view", EventView.class);
    EventView second = viewer.node("second-event-view", EventView.class);
    long[] shownUs = new long[2];
    List<Long> apartUs = new CopyOnWriteArrayList<>();
    viewer.run(
        () -> {
          first.onFrame(frame -> shownUs[0] = frame.timeUs());
          second.onFrame(frame -> shownUs[1] = frame.timeUs());
          // a listener of the window's pulse comes when both have been shown, or neither
          viewer.window.context().panels().onPulse(() -> apartUs.add(shownUs[0] - shownUs[1]));
        });
    viewer.waitFor("both", () -> shownUs[0] > 0 && shownUs[1] > 0);
    apartUs.clear();
    viewer.waitFor("pictures", () -> apartUs.size() > 200);
    assertEquals(Set.of(0L), Set.copyOf(apartUs), "times between both pictures, microseconds");
  }

  private Dimension2D size(String view) {
    Region region = viewer.node(view, Region.class);
    return new Dimension2D(region.getWidth(), region.getHeight());
  }

  private Set<String> tableTexts() {
    return viewer.onFx(
        () ->
            viewer.node("comparison", Parent.class).lookupAll(".label").stream()
                .map(label -> ((Label) label).getText())
                .collect(Collectors.toCollection(TreeSet::new)));
  }

  private static List<String> names(FilterChain chain) {
    return chain.stages().stream().map(ChainStage::name).toList();
  }

  @Test
  void tableShowsTheDifferenceOfTheSecondChain() {
    PlotField x = new PlotField("tracker", "clusters", "x_px");
    PlotField y = new PlotField("tracker", "clusters", "y_px");
    PlotField z = new PlotField("other", "clusters", "x_px");
    List<ComparisonTable.ComparisonLine> lines =
        ComparisonTable.lines(Map.of(x, 50.0), Map.of(x, 51.0));
    assertEquals(
        List.of(
            new ComparisonTable.ComparisonLine(
                "Tracker: clusters", "x, px", "50.000", "51.000", "+2.00 %")),
        lines);
    assertEquals("same", ComparisonTable.lines(Map.of(y, 3.0), Map.of(y, 3.0)).get(0).difference());
    assertEquals("", ComparisonTable.lines(Map.of(y, 3.0), Map.of(z, 3.0)).get(0).difference());
  }

  private PresetFeature presets() {
    return viewer.window.feature(PresetFeature.class);
  }

  @Test
  void nestedChainIsSavedAndLoadedSeparately() {
    viewer = new ViewerHarness(UserSettings.load(folder));
    viewer.open(() -> new ScenePlayable(() -> new BlobSource(Long.MAX_VALUE), "blob"));
    viewer.addNoiseFilters();
    viewer.run(() -> viewer.window.context().editor().addChain());
    viewer.waitFor("its card", () -> viewer.isThere("stage-chain"));
    FilterChain inside = (FilterChain) viewer.session().chain().stage("chain").filter();
    ChainEditor editor =
        viewer.onFx(
            () -> viewer.window.context().editor().inside(viewer.session().chain().stage("chain")));
    viewer.run(() -> editor.moveHere("hot-pixels", Optional.empty()));
    viewer.waitFor("a filter inside", () -> names(inside).equals(List.of("hot-pixels")));
    viewer.run(() -> presets().save("inner", editor));
    viewer.waitFor("the offer", () -> presets().names().equals(List.of("inner")));
    viewer.run(() -> editor.remove(inside.stages().get(0)));
    viewer.waitFor("none inside", () -> inside.stages().isEmpty());
    MenuButton more = viewer.node("more-chain", MenuButton.class);
    Menu menu =
        (Menu)
            more.getItems().stream()
                .filter(item -> "presets-chain".equals(item.getId()))
                .findFirst()
                .orElseThrow();
    viewer.run(more::show);
    viewer.run(menu::show);
    viewer.run(
        () ->
            menu.getItems().stream()
                .filter(item -> "presets-chain-inner".equals(item.getId()))
                .findFirst()
                .orElseThrow()
                .fire());
    viewer.waitFor("it is back", () -> names(inside).equals(List.of("hot-pixels")));
    assertFalse(names(viewer.session().chain()).contains("hot-pixels"));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("that is taken back", () -> insideNow().isEmpty());
  }

  private List<String> insideNow() {
    return names((FilterChain) viewer.session().chain().stage("chain").filter());
  }

  @Test
  void presetIsSavedAndOffered() {
    UserSettings settings = UserSettings.load(folder);
    viewer = new ViewerHarness(settings);
    viewer.open(() -> new ScenePlayable(() -> new BlobSource(Long.MAX_VALUE), "blob"));
    viewer.addNoiseFilters();
    viewer.run(() -> presets().save("usual", viewer.window.context().editor()));
    viewer.waitFor("the file", () -> Files.exists(folder.resolve("presets").resolve("usual.json")));
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor("a comparison", () -> viewer.isThere("first-chain-name"));
    viewer.waitFor(
        "its name in it", () -> viewer.text("first-chain-name").equals("First chain: usual"));
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.waitFor(
        "the offer", () -> viewer.window.context().actions().find("preset-usual").isPresent());
    ChainStage last = viewer.session().chain().stages().get(2);
    viewer.run(() -> viewer.session().player().edit(chain -> chain.remove(last)));
    viewer.waitFor("a shorter chain", () -> viewer.session().chain().stages().size() == 2);
    viewer.run(() -> viewer.window.context().actions().run("preset-usual"));
    viewer.waitFor("the preset", () -> viewer.session().chain().stages().size() == 3);
    viewer.run(() -> presets().save("a/b", viewer.window.context().editor()));
    viewer.waitFor(
        "what is wrong", () -> viewer.text("status-message").contains("a/b: the name of a preset"));
  }

  @Test
  void bannerAboveOnePictureKeepsBothAtOneScale() {
    viewer = new ViewerHarness();
    viewer.openRecording(Recorded.file("dvs128-moving-dark-box.aedat"));
    viewer.run(() -> viewer.window.context().actions().run("compare"));
    viewer.run(() -> viewer.window.context().actions().run("show-plots"));
    viewer.waitFor(
        "the banner of the whole file",
        () ->
            viewer.isThere("camera-choice")
                && !viewer.node("camera-choice", ChoiceBox.class).getItems().isEmpty());
    viewer.waitFor("a second picture", () -> viewer.isThere("second-event-view"));
    EventView first = viewer.node("event-view", EventView.class);
    EventView second = viewer.node("second-event-view", EventView.class);
    Node banner = viewer.node("warnings", Node.class);
    viewer.waitFor("plots below", () -> viewer.isThere("plots"));
    Node plots = viewer.node("plots", Node.class);
    viewer.waitFor(
        "pictures of one size between the banner and the plots",
        () -> isOneSize(first, second) && isAbove(banner, first) && isAbove(first, plots));
    double height = viewer.onFx(first::getHeight);
    viewer.click("warnings-dismiss");
    viewer.waitFor("both are higher", () -> isOneSize(first, second) && first.getHeight() > height);
  }

  private static boolean isAbove(Node upper, Node lower) {
    Bounds above = upper.localToScene(upper.getLayoutBounds());
    Bounds below = lower.localToScene(lower.getLayoutBounds());
    return above.getHeight() > 0 && below.getHeight() > 0 && above.getMaxY() <= below.getMinY() + 1;
  }

  private static boolean isOneSize(EventView first, EventView second) {
    return first.getHeight() == second.getHeight()
        && Math.abs(first.viewpoint().scale() - second.viewpoint().scale()) < 1e-9;
  }
}
