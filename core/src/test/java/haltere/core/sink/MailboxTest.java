package haltere.core.sink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

class MailboxTest {
  @Test
  void newValuesReplaceUnreadOnes() {
    Mailbox<String> mailbox = new Mailbox<>();
    assertNull(mailbox.poll());
    assertNull(mailbox.put("a"));
    assertEquals("a", mailbox.put("b"));
    assertEquals("b", mailbox.poll());
    assertNull(mailbox.poll());
    assertEquals(2, mailbox.puts());
    assertEquals(1, mailbox.conflated());
  }

  @Test
  @Timeout(20)
  void valuesAreTakenOrConflatedInOrder() throws InterruptedException {
    Mailbox<Integer> mailbox = new Mailbox<>();
    int count = 200_000;
    Thread producer =
        new Thread(
            () -> {
              for (int i = 1; i <= count; i++) {
                mailbox.put(i);
              }
            });
    producer.start();
    int last = 0;
    int taken = 0;
    while (last < count) {
      Integer next = mailbox.poll();
      if (next == null) {
        Thread.onSpinWait();
      } else {
        assertTrue(next > last);
        last = next;
        taken++;
      }
    }
    producer.join();
    assertEquals(count, mailbox.puts());
    assertEquals(count, taken + mailbox.conflated());
  }
}
