package haltere.core.pipeline;

import haltere.core.chain.FilterChain;
import haltere.core.stream.internal.MachineFault;
import haltere.core.stream.internal.Reason;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;

/**
 * Changes of a chain that wait for its processing thread.
 *
 * <p>Thread rule: any thread adds; the processing thread applies.
 */
final class ChainEdits {
  private record QueuedEdit(Consumer<FilterChain> change, CompletableFuture<Void> done) {}

  private final Queue<QueuedEdit> waiting = new ConcurrentLinkedQueue<>();

  CompletableFuture<Void> add(Consumer<FilterChain> change) {
    QueuedEdit edit = new QueuedEdit(change, new CompletableFuture<>());
    waiting.add(edit);
    return edit.done;
  }

  void applyTo(FilterChain chain, Consumer<String> failures) {
    for (QueuedEdit edit = waiting.poll(); edit != null; edit = waiting.poll()) {
      try {
        edit.change.accept(chain);
        edit.done.complete(null);
      } catch (RuntimeException | Error thrown) {
        MachineFault.rethrow(thrown);
        String why = Reason.of(thrown).lines().findFirst().orElse("");
        failures.accept("a change of the chain failed: " + why);
        edit.done.completeExceptionally(thrown);
      }
    }
  }
}
