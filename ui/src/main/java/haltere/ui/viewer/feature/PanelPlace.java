package haltere.ui.viewer.feature;

/** Where a panel of the window is shown. */
public enum PanelPlace {
  /** In the column at the right, as a tab beside the chain. */
  SIDE,
  /** Below the events, as wide as they are. */
  BELOW,
  /** At the right of the events, as high as they are. */
  BESIDE
}
