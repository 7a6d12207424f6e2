package haltere.ui.viewer;

/** Where a panel of the window is shown. */
enum PanelPlace {
  /** In the column at the right, as a tab beside the chain. */
  SIDE,
  /** Below the events, as wide as they are. */
  BELOW,
  /** At the right of the events, as high as they are. */
  BESIDE
}
