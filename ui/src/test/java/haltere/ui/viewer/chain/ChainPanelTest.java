package haltere.ui.viewer.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.event.EventPacket;
import haltere.core.extension.Extensions;
import haltere.core.settings.SettingsSchema;
import haltere.ui.viewer.ViewerHarness;
import haltere.ui.viewer.saving.SavingFeature;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Slider;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The chain and its settings, changed by clicks in the real window. */
class ChainPanelTest {
  private static final String NOISE = "background-activity";
  private ViewerHarness viewer;

  @BeforeEach
  void open() {
    viewer = ViewerHarness.withBlobAndNoiseFilters();
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  @Test
  void disabledFilterStopsCounting() {
    ChainStage stage = viewer.session().chain().stage(NOISE);
    viewer.waitFor("events through the filter", () -> stage.timing().eventsIn() > 0);
    viewer.waitFor("counts are shown", () -> viewer.text("counts-" + NOISE).contains("pass"));
    viewer.click("power-" + NOISE);
    viewer.waitFor("off", () -> !stage.isEnabled());
    FilterTiming then = stage.timing();
    long eventsIn = viewer.status().eventsIn();
    viewer.waitFor("more events", () -> viewer.status().eventsIn() > eventsIn + 100);
    assertEquals(then, stage.timing());
    viewer.waitFor("the panel says so", () -> viewer.text("counts-" + NOISE).equals("off"));
    viewer.click("power-" + NOISE);
    viewer.waitFor("on again", () -> stage.timing().eventsIn() > then.eventsIn());
  }

  @Test
  void sliderChangesTheFilterSetting() {
    viewer.click("expand-" + NOISE);
    long before = longValue(NOISE, "correlationUs");
    viewer.click("slider-" + NOISE + "-correlationUs", 0.9, 0.5);
    viewer.waitFor("a larger value", () -> longValue(NOISE, "correlationUs") > before);
    TextField entry = viewer.node("entry-" + NOISE + "-correlationUs", TextField.class);
    assertEquals(Long.toString(longValue(NOISE, "correlationUs")), viewer.onFx(entry::getText));
    viewer.click("reset-" + NOISE + "-correlationUs");
    viewer.waitFor("the default", () -> longValue(NOISE, "correlationUs") == before);
  }

  @Test
  void entryIsExactAndAnInvalidOneShowsTheRange() {
    viewer.click("expand-" + NOISE);
    enter("entry-" + NOISE + "-neighbours", "3");
    viewer.waitFor("three neighbours", () -> longValue(NOISE, "neighbours") == 3);
    Slider slider = viewer.node("slider-" + NOISE + "-neighbours", Slider.class);
    assertEquals(2 / 7.0, viewer.onFx(slider::getValue), 1e-9);
    enter("entry-" + NOISE + "-neighbours", "9");
    viewer.waitFor("the problem", () -> !viewer.text("problem-" + NOISE + "-neighbours").isEmpty());
    String problem = viewer.text("problem-" + NOISE + "-neighbours");
    assertTrue(problem.contains("1 to 8"), problem);
    assertEquals(3, longValue(NOISE, "neighbours"));
    enter("entry-" + NOISE + "-neighbours", "4");
    viewer.waitFor("four neighbours", () -> longValue(NOISE, "neighbours") == 4);
    assertEquals("", viewer.text("problem-" + NOISE + "-neighbours"));
    viewer.click("reset-all-" + NOISE);
    viewer.waitFor("defaults", () -> longValue(NOISE, "neighbours") == 1);
  }

  @Test
  void escapeRestoresTheValueInForce() {
    viewer.click("expand-" + NOISE);
    enter("entry-" + NOISE + "-neighbours", "");
    viewer.waitFor("the problem", () -> !viewer.text("problem-" + NOISE + "-neighbours").isEmpty());
    assertEquals(
        "setting neighbours is empty, it must be a whole number",
        viewer.text("problem-" + NOISE + "-neighbours"));
    viewer.press(KeyCode.ESCAPE);
    TextField entry = viewer.node("entry-" + NOISE + "-neighbours", TextField.class);
    viewer.waitFor("the value in force", () -> entry.getText().equals("1"));
    assertEquals("", viewer.text("problem-" + NOISE + "-neighbours"));
  }

  @Test
  void filterThatFailsAgainIsReportedAgain() {
    EventFilter broken =
        new EventFilter() {
          @Override
          public void process(EventPacket packet) {
            throw new NoClassDefFoundError("org/example/Missing");
          }

          @Override
          public void reset() {}
        };
    FilterChain chain = new FilterChain(viewer.session().chain().geometry());
    chain.add("broken", broken);
    viewer.run(() -> viewer.window.context().editor().replaceAll(chain));
    viewer.waitFor("its card", () -> viewer.isThere("power-broken"));
    awaitFailure();
    viewer.click("dismiss");
    viewer.waitFor("no message", () -> !viewer.text("status-message").contains("broken"));
    viewer.click("power-broken");
    awaitFailure();
    assertFalse(viewer.session().chain().stage("broken").isEnabled());
  }

  @Test
  void jarThatCannotBeUsedIsNamedWhereItsFilterIsMissed(@TempDir Path folder) throws Exception {
    Files.writeString(folder.resolve("broken.jar"), "no jar");
    Extensions.open(folder);
    close();
    open();
    viewer.click("add-filter");
    viewer.waitFor("the jar", () -> viewer.text("extension-problem").startsWith("broken.jar: it"));
    viewer.press(KeyCode.ESCAPE);
  }

  private void awaitFailure() {
    viewer.waitFor(
        "the failure",
        () -> viewer.text("status-message").startsWith("filter broken failed: java.lang.NoClass"));
  }

  @Test
  void checkBoxesAndChoicesChangeFilterSettings() {
    viewer.click("expand-" + NOISE);
    viewer.click("check-" + NOISE + "-samePolarity");
    viewer.waitFor("the flag", () -> Boolean.TRUE.equals(value(NOISE, "samePolarity")));
    add("refractory");
    viewer.click("expand-refractory");
    ChoiceBox<?> choice = viewer.node("choice-refractory-silence", ChoiceBox.class);
    viewer.run(() -> choice.getSelectionModel().select(1));
    viewer.waitFor(
        "the choice", () -> value("refractory", "silence").toString().equals("SINCE_LAST_SEEN"));
  }

  @Test
  void filtersAreAddedMovedAndRemoved() {
    List<String> before = names();
    add("refractory");
    String last = before.get(before.size() - 1);
    assertEquals(before.size() + 1, names().size());
    assertEquals("refractory", names().get(before.size()));
    viewer.click("more-refractory");
    fire("up-refractory");
    viewer.waitFor("it moved", () -> names().indexOf("refractory") == before.size() - 1);
    assertEquals(last, names().get(before.size()));
    viewer.click("more-refractory");
    fire("down-refractory");
    viewer.waitFor("it moved back", () -> names().indexOf("refractory") == before.size());
    viewer.click("more-refractory");
    fire("remove-refractory");
    viewer.waitFor("it is gone", () -> names().equals(before));
    viewer.waitFor("its card is gone", () -> !viewer.isThere("stage-refractory"));
  }

  @Test
  void nestedChainHasItsOwnCards() {
    viewer.click("add-filter");
    enter("add-filter-search", "filters of its own");
    viewer.waitFor("a card for the chain", () -> viewer.isThere("stage-chain"));
    viewer.click("add-filter-chain");
    fire("add-polarity");
    viewer.waitFor("a card inside", () -> viewer.isThere("stage-chain-polarity"));
    ChainStage inner = inside("chain").stages().get(0);
    viewer.waitFor("events through it", () -> inner.timing().eventsIn() > 0);
    viewer.waitFor("its counts", () -> viewer.text("counts-chain-polarity").contains("pass"));
    viewer.click("power-chain-polarity");
    viewer.waitFor("off", () -> !inner.isEnabled());
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("on again", inner::isEnabled);

    Object before = value(inner, "keep");
    viewer.click("expand-chain-polarity");
    ChoiceBox<?> keep = viewer.node("choice-chain-polarity-keep", ChoiceBox.class);
    viewer.run(() -> keep.getSelectionModel().selectNext());
    viewer.waitFor("the choice", () -> !value(inner, "keep").equals(before));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("the choice before", () -> value(inner, "keep").equals(before));

    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("its card is gone", () -> !viewer.isThere("stage-chain-polarity"));
    assertEquals(List.of(), inside("chain").stages());
  }

  @Test
  void cardMovesIntoANestedChainAndOut() {
    viewer.click("add-filter");
    enter("add-filter-search", "filters of its own");
    viewer.waitFor("a card for the chain", () -> viewer.isThere("stage-chain"));
    List<String> outside = names();
    viewer.click("expand-" + NOISE);
    enter("entry-" + NOISE + "-neighbours", "3");
    viewer.waitFor("three neighbours", () -> longValue(NOISE, "neighbours") == 3);

    StageCard chain = viewer.node("stage-chain", StageCard.class);
    viewer.run(() -> ((StageList) chain.lookup(".cards")).drop(NOISE));
    viewer.waitFor("its card inside", () -> viewer.isThere("stage-chain-" + NOISE));
    assertFalse(names().contains(NOISE));
    assertEquals(3, ((Number) value(inside("chain").stage(NOISE), "neighbours")).intValue());

    viewer.click("more-chain-" + NOISE);
    fire("out-chain-" + NOISE);
    viewer.waitFor("its card outside", () -> viewer.isThere("stage-" + NOISE));
    assertEquals(List.of(), inside("chain").stages());
    assertEquals(names().indexOf("chain") - 1, names().indexOf(NOISE));
    assertEquals(3, longValue(NOISE, "neighbours"));

    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("inside again", () -> viewer.isThere("stage-chain-" + NOISE));
    viewer.run(() -> viewer.window.context().actions().run("undo"));
    viewer.waitFor("as at first", () -> names().equals(outside));
    assertEquals(3, longValue(NOISE, "neighbours"));
  }

  @Test
  void chainCannotBeMovedIntoItself() {
    viewer.click("add-filter");
    enter("add-filter-search", "filters of its own");
    viewer.waitFor("a card for the chain", () -> viewer.isThere("stage-chain"));
    viewer.click("add-filter-chain");
    fire("add-polarity");
    viewer.waitFor("a card inside", () -> viewer.isThere("stage-chain-polarity"));
    StageCard inner = viewer.node("stage-chain-polarity", StageCard.class);
    assertFalse(viewer.onFx(() -> inner.accepts("chain")));
    assertTrue(viewer.onFx(() -> inner.accepts(NOISE)));
    assertTrue(viewer.onFx(() -> inner.accepts("chain/polarity")));
  }

  @Test
  void droppedCardTakesThePositionOfTheTarget() {
    List<String> before = names();
    StageCard card = viewer.node("stage-" + before.get(0), StageCard.class);
    viewer.run(() -> card.drop(before.get(2)));
    viewer.waitFor(
        "the last is the first",
        () -> names().equals(List.of(before.get(2), before.get(0), before.get(1))));
  }

  private FilterChain inside(String stage) {
    return (FilterChain) viewer.session().chain().stage(stage).filter();
  }

  @Test
  void chainIsSavedAndLoaded(@TempDir Path folder) throws Exception {
    Path file = folder.resolve("chain.json");
    viewer.click("expand-" + NOISE);
    enter("entry-" + NOISE + "-neighbours", "5");
    viewer.waitFor("five neighbours", () -> longValue(NOISE, "neighbours") == 5);
    viewer.run(() -> viewer.window.feature(SavingFeature.class).saveChain(file));
    viewer.waitFor("the file", () -> Files.exists(file));
    viewer.click("more-" + NOISE);
    fire("remove-" + NOISE);
    viewer.waitFor("it is gone", () -> !names().contains(NOISE));
    viewer.run(() -> viewer.window.feature(SavingFeature.class).loadChain(file));
    viewer.waitFor("it is back", () -> names().contains(NOISE) && viewer.isThere("stage-" + NOISE));
    assertEquals(5, longValue(NOISE, "neighbours"));

    Files.writeString(file, "{\"filters\": [{\"filter\": \"nonsense\"}]}");
    viewer.run(() -> viewer.window.feature(SavingFeature.class).loadChain(file));
    viewer.waitFor(
        "the error", () -> viewer.text("status-message").contains("no filter named nonsense"));
    assertTrue(names().contains(NOISE));
  }

  private void add(String filter) {
    viewer.click("add-filter");
    fire("add-" + filter);
    viewer.waitFor("a card for it", () -> viewer.isThere("stage-" + filter));
  }

  /** Clicks an item of the menu that is open. */
  private void fire(String item) {
    viewer.waitFor("menu item " + item, () -> viewer.isThere(item));
    viewer.click(item);
  }

  private void enter(String id, String text) {
    viewer.click(id);
    TextField entry = viewer.node(id, TextField.class);
    viewer.waitFor("focus", entry::isFocused);
    viewer.run(() -> entry.setText(text));
    viewer.press(KeyCode.ENTER);
  }

  private List<String> names() {
    return viewer.session().chain().stages().stream().map(ChainStage::name).toList();
  }

  private long longValue(String stage, String name) {
    return ((Number) value(stage, name)).longValue();
  }

  private Object value(String stage, String name) {
    return value(viewer.session().chain().stage(stage), name);
  }

  private static Object value(ChainStage stage, String name) {
    return get(((ConfigurableFilter<?>) stage.filter()).settings(), name);
  }

  @SuppressWarnings("unchecked")
  private static <S extends Record> Object get(S settings, String name) {
    return SettingsSchema.of((Class<S>) settings.getClass()).get(settings, name);
  }
}
