package haltere.ui.viewer.chain;

import java.util.List;

/**
 * Chains that are kept under a name, for the whole chain and for those inside of it.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
public interface ChainPresets {
  /** What is kept, by name. */
  List<String> names();

  /** Asks for a name and keeps a chain under it. */
  void keep(ChainEditor chain);

  /** Puts what is kept under a name in place of a chain's filters. */
  void load(String name, ChainEditor chain);
}
