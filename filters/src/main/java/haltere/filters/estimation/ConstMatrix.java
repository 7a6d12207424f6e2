package haltere.filters.estimation;

import java.util.Arrays;
import java.util.Objects;
import org.ejml.data.DMatrixRMaj;

/** An immutable matrix or column vector, for estimates and steps. */
public final class ConstMatrix {
  private final int rows;
  private final int columns;
  private final double[] values;

  private ConstMatrix(int rows, int columns, double[] values) {
    this.rows = rows;
    this.columns = columns;
    this.values = values;
  }

  /**
   * A copy.
   *
   * @param matrix to copy
   * @return independent of the matrix from now on
   */
  public static ConstMatrix copyOf(DMatrixRMaj matrix) {
    return new ConstMatrix(
        matrix.numRows, matrix.numCols, Arrays.copyOf(matrix.data, matrix.getNumElements()));
  }

  /**
   * A column vector.
   *
   * @param values its entries; copied
   * @return independent of the array from now on
   */
  public static ConstMatrix column(double... values) {
    return new ConstMatrix(values.length, 1, values.clone());
  }

  /** {@return the number of columns; 1 for a vector} */
  public int columns() {
    return columns;
  }

  /**
   * An entry.
   *
   * @param row from 0
   * @param column from 0
   * @return its value
   */
  public double get(int row, int column) {
    return values[Objects.checkIndex(row, rows) * columns + Objects.checkIndex(column, columns)];
  }

  /**
   * An entry of a vector, or the entries of a matrix row by row.
   *
   * @param index from 0
   * @return its value
   */
  public double get(int index) {
    return values[index];
  }

  /** {@return a mutable copy} */
  public DMatrixRMaj toMatrix() {
    return new DMatrixRMaj(rows, columns, true, values.clone());
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ConstMatrix that
        && rows == that.rows
        && columns == that.columns
        && Arrays.equals(values, that.values);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * rows + columns) + Arrays.hashCode(values);
  }

  @Override
  public String toString() {
    return toMatrix().toString();
  }
}
