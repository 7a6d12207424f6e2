package haltere.core.overlay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.chain.Outlet;
import haltere.core.overlay.MarkStyle.Role;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class MarkStyleTest {
  @Test
  void styleConsistsOfRoleAndIdentity() {
    assertEquals(new MarkStyle(Role.OBJECT, -1), MarkStyle.of(Role.OBJECT));
    assertNotEquals(MarkStyle.of(Role.OBJECT, 1), MarkStyle.of(Role.OBJECT, 2));
    assertThrows(NullPointerException.class, () -> MarkStyle.of(null));
  }

  @Test
  void layerReceivesSnapshotsOfAnOutletUntilItIsClosed() throws Exception {
    Outlet<String> outlet = new Outlet<>("words", String.class);
    OverlayLayer<String> layer =
        new OverlayLayer<String>("words", outlet::subscribe, (snapshot, canvas) -> {});
    List<String> taken = new ArrayList<>();
    AutoCloseable subscription = layer.subscribe().apply(taken::add);
    outlet.publish("one");
    subscription.close();
    outlet.publish("two");
    assertEquals(List.of("one"), taken);
  }
}
