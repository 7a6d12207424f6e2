package haltere.ui.viewer.controls;

import javafx.scene.Node;
import javafx.scene.shape.FillRule;
import javafx.scene.shape.SVGPath;

/** The icons of the window, as paths on a square of 16 by 16, coloured by the style sheet. */
public enum Icons {
  PLAY("M4 2.5 L13.5 8 L4 13.5 Z"),
  BACKWARDS("M12 2.5 L2.5 8 L12 13.5 Z"),
  RECORD("M8 3 A5 5 0 1 1 8 13 A5 5 0 1 1 8 3 Z"),
  PAUSE("M4 2.5 H7 V13.5 H4 Z M9.5 2.5 H12.5 V13.5 H9.5 Z"),
  REWIND("M2.5 3 H4.5 V13 H2.5 Z M13.5 3 V13 L5.5 8 Z"),
  STEP_BACK("M9.5 3 V13 L2.5 8 Z M11 3 H13 V13 H11 Z"),
  STEP_FORWARD("M6.5 3 V13 L13.5 8 Z M3 3 H5 V13 H3 Z"),
  SLOWER("M8 3.5 V12.5 L2 8 Z M14 3.5 V12.5 L8 8 Z"),
  FASTER("M8 3.5 V12.5 L14 8 Z M2 3.5 V12.5 L8 8 Z"),
  LOOP(
      "M4.5 4 H11 L9.5 2.5 L10.6 1.4 L14 4.75 L10.6 8.1 L9.5 7 L11 5.5 H4.5 V8 H3 V5.5 Q3 4 4.5 4 Z"
          + " M11.5 12 H5 L6.5 13.5 L5.4 14.6 L2 11.25 L5.4 7.9 L6.5 9 L5 10.5 H11.5 V8 H13 V10.5"
          + " Q13 12 11.5 12 Z"),
  MARK_IN("M4 2.5 H9 V4 H5.5 V12 H9 V13.5 H4 Z"),
  MARK_OUT("M12 2.5 H7 V4 H10.5 V12 H7 V13.5 H12 Z"),
  MARK("M4.5 2 H11.5 V14 L8 11 L4.5 14 Z"),
  RESET("M8 3 A5.2 5.2 0 1 1 3 9.6 L4.5 9.2 A3.7 3.7 0 1 0 8 4.5 V7 L3.8 3.75 L8 0.5 Z"),
  MORE("M7 2.5 H9 V4.5 H7 Z M7 7 H9 V9 H7 Z M7 11.5 H9 V13.5 H7 Z"),
  RIGHT("M11.5 8 L6 13 L4.9 11.9 L9.2 8 L4.9 4.1 L6 3 Z"),
  LESS("M2.5 7.2 H13.5 V8.8 H2.5 Z"),
  REMOVE("M4 3 L8 7 L12 3 L13 4 L9 8 L13 12 L12 13 L8 9 L4 13 L3 12 L7 8 L3 4 Z"),
  TAPE("M1.5 5.5 H14.5 V10.5 H12.6 V8 H11.4 V10.5 H8.6 V8 H7.4 V10.5 H4.6 V8 H3.4 V10.5 H1.5 Z"),
  REGION(
      "M2 2 H6 V3.5 H3.5 V6 H2 Z M10 2 H14 V6 H12.5 V3.5 H10 Z M2 10 H3.5 V12.5 H6 V14 H2 Z M12.5"
          + " 10 H14 V14 H10 V12.5 H12.5 Z"),
  CUBE(
      "M8 1 L14 4.3 V11.2 L8 15 L2 11.2 V4.3 Z M8 2.8 L4.6 4.7 L8 6.6 L11.4 4.7 Z M3.5 5.9 V10.3"
          + " L7.3 12.7 V8 Z M12.5 5.9 L8.7 8 V12.7 L12.5 10.3 Z"),
  COMPARE("M2 3 H7.2 V13 H2 Z M8.8 3 H14 V13 H8.8 Z M10.3 4.5 V11.5 H12.5 V4.5 Z"),
  SEARCH(
      "M6.5 1.5 A5 5 0 1 1 6.5 11.5 A5 5 0 1 1 6.5 1.5 Z M6.5 3 A3.5 3.5 0 1 0 6.5 10 A3.5 3.5 0 1"
          + " 0 6.5 3 Z M10.2 11.2 L11.2 10.2 L14.8 13.8 L13.8 14.8 Z"),
  FRAME("M1.5 3 H14.5 V13 H1.5 Z M3 4.5 V11.5 H13 V4.5 Z M4 10.5 L7 6.5 L9 9 L10 8 L12 10.5 Z"),
  DENOISE("M1.5 3 H14.5 L9.6 8.8 V12.2 L6.4 14.5 V8.8 Z"),
  OBJECTS(
      "M2 2 H6 V3.5 H3.5 V6 H2 Z M10 2 H14 V6 H12.5 V3.5 H10 Z M2 10 H3.5 V12.5 H6 V14 H2 Z M12.5"
          + " 10 H14 V14 H10 V12.5 H12.5 Z M8 5.5 A2.5 2.5 0 1 1 8 10.5 A2.5 2.5 0 1 1 8 5.5 Z"),
  WINGS("M7 8 Q3 3 1 6 Q0.5 9.5 7 9.5 Z M9 8 Q13 3 15 6 Q15.5 9.5 9 9.5 Z M7.4 4 H8.6 V13 H7.4 Z"),
  ADD("M7.2 2.5 H8.8 V7.2 H13.5 V8.8 H8.8 V13.5 H7.2 V8.8 H2.5 V7.2 H7.2 Z");

  private final String path;

  Icons(String path) {
    this.path = path;
  }

  /** A new node for a button. */
  public Node node() {
    SVGPath shape = new SVGPath();
    // all icons have the same size, whatever their shape
    shape.setContent("M0 0 H0 M16 16 H16 " + path);
    shape.setFillRule(FillRule.EVEN_ODD);
    shape.getStyleClass().add("icon");
    return shape;
  }
}
