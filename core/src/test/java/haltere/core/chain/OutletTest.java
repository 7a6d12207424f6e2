package haltere.core.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class OutletTest {
  private final Outlet<String> outlet = new Outlet<>("words", String.class);

  @Test
  void subscribersReceiveResultsInOrderUntilTheyUnsubscribe() {
    List<String> early = new ArrayList<>();
    List<String> late = new ArrayList<>();
    Outlet.Subscription subscription = outlet.subscribe(early::add);
    outlet.publish("one");
    outlet.subscribe(late::add);
    outlet.publish("two");
    subscription.close();
    outlet.publish("three");
    assertEquals(List.of("one", "two"), early);
    assertEquals(List.of("two", "three"), late);
  }

  @Test
  void filterKnowsWhetherAnOutletHasSubscribers() {
    assertFalse(outlet.hasSubscribers());
    Outlet.Subscription subscription = outlet.subscribe(word -> {});
    assertTrue(outlet.hasSubscribers());
    subscription.close();
    subscription.close();
    assertFalse(outlet.hasSubscribers());
  }

  @Test
  void subscriptionsOfOneSubscriberAreIndependent() {
    List<String> words = new ArrayList<>();
    java.util.function.Consumer<String> consumer = words::add;
    Outlet.Subscription first = outlet.subscribe(consumer);
    outlet.subscribe(consumer);
    outlet.publish("one");
    assertEquals(List.of("one", "one"), words);
    first.close();
    first.close();
    outlet.publish("two");
    assertEquals(List.of("one", "one", "two"), words);
  }

  @Test
  void subscriberMayUnsubscribeDuringACall() {
    List<String> words = new ArrayList<>();
    List<Outlet.Subscription> own = new ArrayList<>();
    own.add(
        outlet.subscribe(
            word -> {
              words.add(word);
              own.get(0).close();
            }));
    outlet.publish("one");
    outlet.publish("two");
    assertEquals(List.of("one"), words);
  }
}
