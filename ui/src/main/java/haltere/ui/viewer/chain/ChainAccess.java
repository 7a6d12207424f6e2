package haltere.ui.viewer.chain;

import haltere.core.chain.FilterChain;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/** Runs changes of a chain between two packets, on the thread that the chain belongs to. */
@FunctionalInterface
public interface ChainAccess {
  /**
   * Runs a change.
   *
   * @return completed when it has been made; fails with what it throws
   */
  CompletableFuture<Void> edit(Consumer<FilterChain> change);
}
