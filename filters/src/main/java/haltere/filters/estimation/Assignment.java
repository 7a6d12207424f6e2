package haltere.filters.estimation;

import java.util.Arrays;
import java.util.Objects;

/**
 * Assigns rows to columns, one to one, with minimum total cost, such as tracks to measurements.
 * Pairs can be forbidden (outside a gate), and a row or a column may stay unassigned at a stated
 * cost. All pairs are assigned jointly, which avoids the errors of a greedy assignment.
 *
 * <p>Shortest augmenting paths with dual prices, O(n² m) for n ≤ m: R. Jonker and A. Volgenant
 * (1987), "A Shortest Augmenting Path Algorithm for Dense and Sparse Linear Assignment Problems",
 * Computing 38, in the rectangular form of D. F. Crouse (2016), "On Implementing 2D Rectangular
 * Assignment Algorithms", IEEE Transactions on Aerospace and Electronic Systems 52(4).
 *
 * <p>With r and c the costs of a row and of a column that stay unassigned, a pair changes the sum
 * by w = cost − r − c against leaving both. Pairs with w ≥ 0 are never needed, so that they and the
 * forbidden ones get w = 0; the full assignment of least w is then optimal, and its pairs with w =
 * 0 are dropped. No dummy rows or columns are needed.
 *
 * <p>Usage: {@link #start}, {@link #setCost} for the pairs that are allowed, {@link #solve}, then
 * read {@link #columnOf} and {@link #rowOf}. Nothing is allocated after the construction. Equal
 * inputs give equal outputs, ties included.
 *
 * <p>Thread rule: for one thread at a time.
 */
public final class Assignment {
  /** Stands for no row or no column. */
  public static final int NONE = -1;

  /** Costs of greater size would overflow when they are added up. */
  private static final double MAX_COST = 1e150;

  private final int maxRows;
  private final int maxColumns;
  private final double[] costs;
  private final int[] columnOfRow;
  private final int[] rowOfColumn;

  // Below, "near" is the shorter side of the matrix and "far" the longer one.
  private final double[] nearPotential;
  private final double[] farPotential;
  private final double[] distance;
  private final int[] from;
  private final int[] open;
  private final int[] farOfNear;
  private final int[] nearOfFar;
  private final int[] closed;

  private int rows;
  private int columns;
  private double unassigned;
  private int nearStride;
  private int farStride;

  /**
   * Space for a matrix.
   *
   * @param maxRows maximum number of rows, at least 0
   * @param maxColumns maximum number of columns, at least 0
   */
  public Assignment(int maxRows, int maxColumns) {
    if (maxRows < 0 || maxColumns < 0) {
      throw new IllegalArgumentException(
          "a matrix cannot have " + maxRows + " x " + maxColumns + " entries");
    }
    this.maxRows = maxRows;
    this.maxColumns = maxColumns;
    int near = Math.min(maxRows, maxColumns);
    int far = Math.max(maxRows, maxColumns);
    costs = new double[Math.multiplyExact(maxRows, maxColumns)];
    columnOfRow = new int[maxRows];
    rowOfColumn = new int[maxColumns];
    nearPotential = new double[near];
    farOfNear = new int[near];
    farPotential = new double[far];
    nearOfFar = new int[far];
    distance = new double[far];
    from = new int[far];
    open = new int[far];
    closed = new int[far];
  }

  /**
   * Begins a new problem in which all pairs are forbidden and nothing is assigned.
   *
   * @param rows 0 to the most rows
   * @param columns 0 to the most columns
   */
  public void start(int rows, int columns) {
    if (rows < 0 || rows > maxRows || columns < 0 || columns > maxColumns) {
      throw new IllegalArgumentException(
          rows
              + " x "
              + columns
              + " is outside the room for "
              + maxRows
              + " x "
              + maxColumns
              + " entries");
    }
    this.rows = rows;
    this.columns = columns;
    Arrays.fill(costs, 0, rows * columns, Double.POSITIVE_INFINITY);
    Arrays.fill(columnOfRow, 0, rows, NONE);
    Arrays.fill(rowOfColumn, 0, columns, NONE);
  }

  /**
   * Sets the cost of a pair.
   *
   * @param row 0 to rows − 1
   * @param column 0 to columns − 1
   * @param cost at most 1e150 in size, or positive infinity for a pair that is forbidden
   */
  public void setCost(int row, int column, double cost) {
    Objects.checkIndex(row, rows);
    Objects.checkIndex(column, columns);
    if (cost != Double.POSITIVE_INFINITY) {
      requireCost("cost of a pair", cost);
    }
    costs[row * columns + column] = cost;
  }

  /**
   * Finds an assignment of least total cost. A pair with the same cost as two unassigned ends is
   * not assigned. Costs are compared with the precision of a double at the largest one, so that
   * they should have one scale.
   *
   * @param unassignedRow cost of each unassigned row, at most 1e150 in size
   * @param unassignedColumn cost of each unassigned column, at most 1e150 in size
   * @return the total cost
   */
  public double solve(double unassignedRow, double unassignedColumn) {
    requireCost("cost of an unassigned row", unassignedRow);
    requireCost("cost of an unassigned column", unassignedColumn);
    unassigned = unassignedRow + unassignedColumn;
    boolean rowsAreNear = rows <= columns;
    int near = Math.min(rows, columns);
    int far = Math.max(rows, columns);
    nearStride = rowsAreNear ? columns : 1;
    farStride = rowsAreNear ? 1 : columns;
    Arrays.fill(nearPotential, 0, near, 0);
    Arrays.fill(farPotential, 0, far, 0);
    Arrays.fill(farOfNear, 0, near, NONE);
    Arrays.fill(nearOfFar, 0, far, NONE);
    for (int i = 0; i < near; i++) {
      augment(i, far);
    }
    Arrays.fill(columnOfRow, 0, rows, NONE);
    Arrays.fill(rowOfColumn, 0, columns, NONE);
    int pairs = 0;
    double totalCost = 0;
    for (int i = 0; i < near; i++) {
      int j = farOfNear[i];
      if (change(i, j) < 0) {
        int row = rowsAreNear ? i : j;
        int column = rowsAreNear ? j : i;
        columnOfRow[row] = column;
        rowOfColumn[column] = row;
        totalCost += costs[row * columns + column];
        pairs++;
      }
    }
    return totalCost + (rows - pairs) * unassignedRow + (columns - pairs) * unassignedColumn;
  }

  /**
   * The column assigned to a row.
   *
   * @param row 0 to rows − 1
   * @return a column or {@link #NONE}
   */
  public int columnOf(int row) {
    return columnOfRow[Objects.checkIndex(row, rows)];
  }

  /**
   * The row assigned to a column.
   *
   * @param column 0 to columns − 1
   * @return a row or {@link #NONE}
   */
  public int rowOf(int column) {
    return rowOfColumn[Objects.checkIndex(column, columns)];
  }

  /** Assigns another one of the near side along the shortest augmenting path. */
  private void augment(int start, int far) {
    for (int j = 0; j < far; j++) {
      open[j] = j;
      distance[j] = Double.POSITIVE_INFINITY;
    }
    int openCount = far;
    int closedCount = 0;
    int i = start;
    double reached = 0;
    int end = NONE;
    while (end == NONE) {
      int nearest = 0;
      for (int k = 0; k < openCount; k++) {
        int j = open[k];
        double d = reached + (change(i, j) - nearPotential[i] - farPotential[j]);
        if (d < distance[j]) {
          distance[j] = d;
          from[j] = i;
        }
        double best = distance[open[nearest]];
        if (distance[j] < best || distance[j] == best && nearOfFar[j] == NONE) {
          nearest = k;
        }
      }
      int j = open[nearest];
      reached = distance[j];
      open[nearest] = open[--openCount];
      closed[closedCount++] = j;
      if (nearOfFar[j] == NONE) {
        end = j;
      } else {
        i = nearOfFar[j];
      }
    }
    nearPotential[start] += reached;
    for (int k = 0; k < closedCount; k++) {
      int j = closed[k];
      double ahead = reached - distance[j];
      farPotential[j] -= ahead;
      if (nearOfFar[j] != NONE) {
        nearPotential[nearOfFar[j]] += ahead;
      }
    }
    int j = end;
    do {
      i = from[j];
      nearOfFar[j] = i;
      int before = farOfNear[i];
      farOfNear[i] = j;
      j = before;
    } while (i != start);
  }

  /** Change of the cost by a pair against two unassigned ends; 0 without an advantage. */
  private double change(int i, int j) {
    return Math.min(costs[i * nearStride + j * farStride] - unassigned, 0);
  }

  private static void requireCost(String what, double cost) {
    if (!(Math.abs(cost) <= MAX_COST)) {
      throw new IllegalArgumentException(
          what + " must be at most " + MAX_COST + " in size: " + cost);
    }
  }
}
