package com.example.imagej;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.OverlayCanvas;
import ij.gui.EllipseRoi;
import ij.gui.Line;
import ij.gui.Overlay;
import ij.gui.PolygonRoi;
import ij.gui.Roi;
import ij.gui.TextRoi;
import java.awt.Color;

/** Marks in a slice: pixel centres at half coordinates and rows from the top, as in ImageJ. */
record RoiCanvas(Overlay overlay, int height, int slice) implements OverlayCanvas {
  /** Maximum number of marks, which take some 100 MB. */
  private static final int MAX_MARKS = 300_000;

  private void add(Roi roi, MarkStyle style) {
    if (overlay.size() == MAX_MARKS) {
      return;
    }
    // steps of the golden ratio keep the hues of neighbouring identities apart
    roi.setStrokeColor(Color.getHSBColor(Math.max(0.1f, style.identity() * 0.618f), 1, 1));
    roi.setPosition(slice);
    overlay.add(roi);
  }

  private double row(double y) {
    return height - 0.5 - y;
  }

  @Override
  public void circle(double x, double y, double radius, MarkStyle style) {
    ellipse(x, y, radius, radius, 0, style);
  }

  @Override
  public void line(double x1, double y1, double x2, double y2, MarkStyle style) {
    add(new Line(x1 + 0.5, row(y1), x2 + 0.5, row(y2)), style);
  }

  @Override
  public void polyline(double[] x, double[] y, int points, MarkStyle style) {
    float[] columns = new float[points];
    float[] rows = new float[points];
    for (int i = 0; i < points; i++) {
      columns[i] = (float) (x[i] + 0.5);
      rows[i] = (float) row(y[i]);
    }
    add(new PolygonRoi(columns, rows, points, Roi.POLYLINE), style);
  }

  @Override
  public void ellipse(double x, double y, double a, double b, double angleRad, MarkStyle style) {
    double longer = Math.max(a, b);
    double angle = a >= b ? angleRad : angleRad + Math.PI / 2;
    double dx = longer * Math.cos(angle);
    double dy = longer * Math.sin(angle);
    double ratio = Math.min(a, b) / longer;
    add(new EllipseRoi(x + 0.5 - dx, row(y - dy), x + 0.5 + dx, row(y + dy), ratio), style);
  }

  @Override
  public void rectangle(double x, double y, double columns, double rows, MarkStyle style) {
    add(new Roi(x + 0.5, row(y + rows), columns, rows), style);
  }

  @Override
  public void text(double x, double y, String text, MarkStyle style) {
    add(new TextRoi(x + 0.5, row(y), text), style);
  }
}
