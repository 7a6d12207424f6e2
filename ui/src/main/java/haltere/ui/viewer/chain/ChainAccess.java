package haltere.ui.viewer.chain;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * Runs tasks on a chain between two packets, on the chain's thread.
 *
 * @param edit runs a change; a paused player shows the moment again
 * @param adjust runs a manual change, which preserves the filters' other state
 * @param read reads from the chain
 */
public record ChainAccess(Work edit, Work adjust, Work read) {
  /** A way to reach the chain. */
  @FunctionalInterface
  public interface Work {
    /** Runs a task. The future completes afterwards; it fails with the task's exception. */
    CompletableFuture<Void> run(Consumer<FilterChain> work);
  }

  /** The chain of a player. */
  public static ChainAccess of(Player player) {
    return new ChainAccess(player::edit, player::adjust, player::read);
  }

  /** A chain that is worked on wherever the first chain of a player is. */
  public static ChainAccess beside(Player player, FilterChain chain) {
    Work read = work -> player.read(first -> work.accept(chain));
    return new ChainAccess(
        work -> read.run(work).thenCompose(done -> player.refresh()), read, read);
  }
}
