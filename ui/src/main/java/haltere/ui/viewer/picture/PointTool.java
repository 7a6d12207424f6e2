package haltere.ui.viewer.picture;

/**
 * Points at pixels with the keys, so that what stands under the mouse can be read without one.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class PointTool implements ViewTool {
  @Override
  public String hint() {
    return "The pixel at the cross is described below the picture.";
  }

  @Override
  public void pressed(double x, double y) {}
}
