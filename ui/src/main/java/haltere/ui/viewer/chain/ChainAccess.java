package haltere.ui.viewer.chain;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/** Runs work on a chain between two packets, on the thread that the chain belongs to. */
public interface ChainAccess {
  /**
   * Runs a change; in a pause the moment is shown anew. Completed when it has been made; fails with
   * what it throws.
   */
  CompletableFuture<Void> edit(Consumer<FilterChain> change);

  /**
   * Runs a change by hand, with which what filters know at this moment stays. Completed as {@link
   * #edit} is.
   */
  default CompletableFuture<Void> adjust(Consumer<FilterChain> change) {
    return read(change);
  }

  /** Looks at the chain. Completed when that is done; fails with what it throws. */
  CompletableFuture<Void> read(Consumer<FilterChain> reader);

  /** The chain of a player. */
  static ChainAccess of(Player player) {
    return new ChainAccess() {
      @Override
      public CompletableFuture<Void> edit(Consumer<FilterChain> change) {
        return player.edit(change);
      }

      @Override
      public CompletableFuture<Void> adjust(Consumer<FilterChain> change) {
        return player.adjust(change);
      }

      @Override
      public CompletableFuture<Void> read(Consumer<FilterChain> reader) {
        return player.read(reader);
      }
    };
  }

  /** A chain that is worked on wherever the first chain of a player is. */
  static ChainAccess beside(Player player, FilterChain chain) {
    return new ChainAccess() {
      @Override
      public CompletableFuture<Void> edit(Consumer<FilterChain> change) {
        return player.read(first -> change.accept(chain)).thenCompose(done -> player.refresh());
      }

      @Override
      public CompletableFuture<Void> read(Consumer<FilterChain> reader) {
        return player.read(first -> reader.accept(chain));
      }
    };
  }
}
