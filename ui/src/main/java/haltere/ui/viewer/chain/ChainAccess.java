package haltere.ui.viewer.chain;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * Runs work on a chain between two packets, on the thread that the chain belongs to.
 *
 * @param edit runs a change; in a pause the moment is shown anew
 * @param adjust runs a change by hand, with which what filters know at this moment stays
 * @param read looks at the chain
 */
public record ChainAccess(Work edit, Work adjust, Work read) {
  /** A way to reach the chain. */
  @FunctionalInterface
  public interface Work {
    /** Runs something. Completed when that is done; fails with what it throws. */
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
