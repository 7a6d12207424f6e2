package haltere.ui.viewer.chain;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.sink.internal.Unchecked;

/**
 * Moves stages into and out of nested chains. A path consists of the names of the chains and the
 * stage, separated by slashes.
 *
 * <p>Thread rule: the processing thread only.
 */
final class StageMoves {
  private StageMoves() {}

  /** Whether a chain is a stage itself, or nested in it. */
  static boolean isWithin(String chainPrefix, String stagePath) {
    return chainPrefix.startsWith(stagePath + "/");
  }

  /** The path of the chain that a stage is in, with a slash at its end; empty for the outermost. */
  static String prefix(String stagePath) {
    return stagePath.substring(0, stagePath.lastIndexOf('/') + 1);
  }

  /** The name of a stage in its own chain. */
  static String name(String stagePath) {
    return stagePath.substring(stagePath.lastIndexOf('/') + 1);
  }

  /** A nested chain, or the outermost one itself. */
  static FilterChain chain(FilterChain outermost, String prefix) {
    FilterChain found = outermost;
    for (String name : prefix.split("/")) {
      if (!name.isEmpty()) {
        found = (FilterChain) found.stage(name).filter();
      }
    }
    return found;
  }

  /**
   * Moves a stage to a chain with a path prefix, before a named stage, or to the end for an empty
   * name. A new filter with the same settings is created, because a filter belongs to one chain.
   */
  static void move(FilterChain outermost, String stagePath, String prefix, String before) {
    if (isWithin(prefix, stagePath)) {
      throw new IllegalArgumentException("a chain cannot be moved into itself");
    }
    FilterChain from = chain(outermost, prefix(stagePath));
    FilterChain to = chain(outermost, prefix);
    ChainStage moved = from.stage(name(stagePath));
    ChainStage again = copy(moved, to);
    ChainStage next = before.isEmpty() ? null : to.stage(before);
    from.remove(moved); // before it is added again, so that its name is free
    int place = next == null ? to.stages().size() : to.stages().indexOf(next);
    to.add(again.kind(), again.filter(), again.isEnabled(), place);
  }

  private static ChainStage copy(ChainStage stage, FilterChain target) {
    FilterChain alone = new FilterChain(target.geometry());
    alone.add(stage.kind(), stage.filter(), stage.isEnabled(), 0);
    String json = ChainFile.write(alone);
    return Unchecked.read(() -> ChainFile.parse(json, stage.name(), target.geometry()))
        .stages()
        .get(0);
  }
}
