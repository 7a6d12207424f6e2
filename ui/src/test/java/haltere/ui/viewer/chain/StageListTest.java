package haltere.ui.viewer.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import haltere.ui.viewer.ViewerHarness;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import javafx.scene.control.Label;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Cards of a chain come one in a step, so that none of them keeps the window for long. */
class StageListTest {
  private final Deque<Runnable> steps = new ArrayDeque<>();
  private StageList list;
  private ViewerHarness viewer;

  @BeforeEach
  void make() {
    viewer = ViewerHarness.withBlob();
    list =
        viewer.onFx(
            () -> {
              ChainEditor editor = new ChainEditor(problem -> {}, new EditHistory());
              StageList made = new StageList(editor, new Label("none"));
              made.reset(List.of(), steps::add);
              steps.remove().run();
              return made;
            });
  }

  @AfterEach
  void close() {
    viewer.close();
  }

  private static List<StageState> chain(String... filters) {
    FilterChain chain = new FilterChain(new SensorGeometry(32, 32));
    for (String name : filters) {
      chain.add(Filters.named(name));
    }
    return StageState.of(chain);
  }

  private List<String> cards() {
    return list.getChildren().stream()
        .filter(StageCard.class::isInstance)
        .map(card -> card.getId().substring("stage-".length()))
        .toList();
  }

  private List<String> shownAfter(Runnable work) {
    return viewer.onFx(
        () -> {
          work.run();
          return cards();
        });
  }

  @Test
  void cardsOfANewChainAppearOneByOneInOrder() {
    List<StageState> stages = chain("background-activity", "hot-pixels", "refractory");
    assertEquals(List.of(), shownAfter(() -> list.reset(stages, steps::add)));
    assertEquals(List.of("background-activity"), shownAfter(() -> steps.remove().run()));
    assertEquals(
        List.of("background-activity", "hot-pixels"), shownAfter(() -> steps.remove().run()));
    assertEquals(
        List.of("background-activity", "hot-pixels", "refractory"),
        shownAfter(() -> steps.remove().run()));
    assertEquals(0, steps.size());
  }

  @Test
  void firstNewCardAppearsAtOnceAndExistingCardsRemain() {
    List<StageState> before = chain("hot-pixels");
    shownAfter(() -> list.show(before));
    List<StageState> more = chain("background-activity", "refractory");
    List<StageState> all = List.of(more.get(0), before.get(0), more.get(1));
    assertEquals(List.of("background-activity", "hot-pixels"), shownAfter(() -> list.show(all)));
    assertEquals(
        List.of("background-activity", "hot-pixels", "refractory"),
        shownAfter(() -> steps.remove().run()));
  }

  @Test
  void cardsOfASupersededChainDoNotAppear() {
    shownAfter(() -> list.show(chain("background-activity", "refractory")));
    List<StageState> other = chain("hot-pixels");
    assertEquals(List.of("hot-pixels"), shownAfter(() -> list.show(other)));
    assertEquals(List.of("hot-pixels"), shownAfter(() -> steps.remove().run()));
  }
}
