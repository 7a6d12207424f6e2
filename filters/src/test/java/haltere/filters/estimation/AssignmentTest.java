package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.testing.Allocation;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class AssignmentTest {
  private static final double FORBIDDEN = Double.POSITIVE_INFINITY;

  /** The least cost there is, by trying every way. */
  private static double bruteForce(double[][] costs, int columns, double row, double column) {
    return bruteForce(costs, 0, new boolean[columns], row, column);
  }

  private static double bruteForce(
      double[][] costs, int i, boolean[] taken, double row, double column) {
    if (i == costs.length) {
      double sum = 0;
      for (boolean t : taken) {
        sum += t ? 0 : column;
      }
      return sum;
    }
    double least = row + bruteForce(costs, i + 1, taken, row, column);
    for (int j = 0; j < taken.length; j++) {
      if (!taken[j] && costs[i][j] < FORBIDDEN) {
        taken[j] = true;
        least = Math.min(least, costs[i][j] + bruteForce(costs, i + 1, taken, row, column));
        taken[j] = false;
      }
    }
    return least;
  }

  private static double solve(
      Assignment assignment, double[][] costs, int columns, double row, double column) {
    assignment.start(costs.length, columns);
    for (int i = 0; i < costs.length; i++) {
      for (int j = 0; j < columns; j++) {
        assignment.setCost(i, j, costs[i][j]);
      }
    }
    return assignment.solve(row, column);
  }

  /** One to one, nothing forbidden, and the total is the sum of what was assigned. */
  private static double checkedSolution(
      Assignment assignment, double[][] costs, int columns, double row, double column) {
    double total = solve(assignment, costs, columns, row, column);
    double sum = 0;
    int pairs = 0;
    for (int i = 0; i < costs.length; i++) {
      int j = assignment.columnOf(i);
      if (j != Assignment.NONE) {
        assertEquals(i, assignment.rowOf(j));
        assertTrue(costs[i][j] < FORBIDDEN, "a forbidden pair was assigned");
        sum += costs[i][j];
        pairs++;
      }
    }
    for (int j = 0; j < columns; j++) {
      int i = assignment.rowOf(j);
      assertTrue(i == Assignment.NONE || assignment.columnOf(i) == j);
    }
    sum += (costs.length - pairs) * row + (columns - pairs) * column;
    assertEquals(total, sum, 1e-9);
    return total;
  }

  @Test
  void costIsMinimalOnRandomMatricesOfAllSizesUpToSeven() {
    SplittableRandom random = new SplittableRandom(4);
    Assignment assignment = new Assignment(7, 7);
    for (int run = 0; run < 12; run++) {
      for (int rows = 0; rows <= 7; rows++) {
        for (int columns = 0; columns <= 7; columns++) {
          boolean ties = run % 3 == 1;
          double share = run % 4 == 3 ? 0.6 : 0.15;
          double[][] costs = new double[rows][columns];
          for (double[] line : costs) {
            for (int j = 0; j < columns; j++) {
              double cost = ties ? random.nextInt(4) : random.nextDouble(-2, 10);
              line[j] = random.nextDouble() < share ? FORBIDDEN : cost;
            }
          }
          double row = ties ? random.nextInt(4) : random.nextDouble(-1, 6);
          double column = ties ? random.nextInt(4) : random.nextDouble(-1, 6);
          double cost = checkedSolution(assignment, costs, columns, row, column);
          assertEquals(bruteForce(costs, columns, row, column), cost, 1e-9);
        }
      }
    }
  }

  @Test
  void optimumIsBelowTheGreedyCost() {
    // Greedy takes the 1 and then must take the 100; together 2 + 3 is the least.
    Assignment assignment = new Assignment(2, 2);
    assertEquals(5, solve(assignment, new double[][] {{1, 2}, {3, 100}}, 2, 1000, 1000));
    assertEquals(1, assignment.columnOf(0));
    assertEquals(0, assignment.columnOf(1));
  }

  @Test
  void pairAboveTheUnassignedCostStaysUnassigned() {
    Assignment assignment = new Assignment(2, 3);
    double[][] costs = {{1, 9, 9}, {9, 6.5, 9}};
    // 1 + (3 + 2 · 3): the pair of 6.5 costs more than 3 + 3.
    assertEquals(10, solve(assignment, costs, 3, 3, 3));
    assertEquals(0, assignment.columnOf(0));
    assertEquals(Assignment.NONE, assignment.columnOf(1));
    assertEquals(Assignment.NONE, assignment.rowOf(1));
    assertEquals(Assignment.NONE, assignment.rowOf(2));
    // 1 + 6.5 + 4 with dearer rows.
    assertEquals(10.5, solve(assignment, costs, 3, 4, 3));
    assertEquals(1, assignment.columnOf(1));
  }

  @Test
  void tieWithTheUnassignedCostStaysUnassigned() {
    Assignment assignment = new Assignment(1, 1);
    assertEquals(5, solve(assignment, new double[][] {{5}}, 1, 2, 3));
    assertEquals(Assignment.NONE, assignment.columnOf(0));
  }

  @Test
  void tiesAreDecidedReproducibly() {
    double[][] costs = new double[6][5];
    Assignment assignment = new Assignment(6, 5);
    double total = checkedSolution(assignment, costs, 5, 1, 1);
    Assignment fresh = new Assignment(9, 9);
    solve(fresh, costs, 5, 1, 1);
    for (int i = 0; i < 6; i++) {
      assertEquals(assignment.columnOf(i), fresh.columnOf(i));
    }
    assertEquals(1, total, "five pairs for nothing, one row over");
  }

  @Test
  void emptyMatrixAssignsNothing() {
    Assignment assignment = new Assignment(3, 3);
    assignment.start(0, 0);
    assertEquals(0, assignment.solve(2, 3));
    assignment.start(3, 0);
    assertEquals(6, assignment.solve(2, 3));
    assertEquals(Assignment.NONE, assignment.columnOf(2));
    assignment.start(0, 3);
    assertEquals(9, assignment.solve(2, 3));
    assertEquals(Assignment.NONE, assignment.rowOf(2));
    new Assignment(0, 0).start(0, 0);
  }

  @Test
  void forbiddenPairsStayUnassigned() {
    Assignment assignment = new Assignment(3, 2);
    assignment.start(3, 2);
    assertEquals(3 * 2 + 2 * 5, assignment.solve(2, 5));
    for (int i = 0; i < 3; i++) {
      assertEquals(Assignment.NONE, assignment.columnOf(i));
    }
  }

  @Test
  void assignmentProblemsAreIndependent() {
    Assignment assignment = new Assignment(2, 2);
    solve(assignment, new double[][] {{1, 2}, {2, 1}}, 2, 10, 10);
    assignment.start(1, 2);
    assertEquals(Assignment.NONE, assignment.columnOf(0));
    assertEquals(30, assignment.solve(10, 10));
    assertThrows(IndexOutOfBoundsException.class, () -> assignment.columnOf(1));
  }

  @Test
  void invalidCostsAndIndicesAreRejected() {
    Assignment assignment = new Assignment(2, 3);
    assertThrows(IllegalArgumentException.class, () -> assignment.start(3, 3));
    assertThrows(IllegalArgumentException.class, () -> assignment.start(2, 4));
    assertThrows(IllegalArgumentException.class, () -> assignment.start(-1, 0));
    assertThrows(IllegalArgumentException.class, () -> new Assignment(-1, 2));
    assignment.start(2, 3);
    for (double cost : new double[] {Double.NaN, Double.NEGATIVE_INFINITY, 1e151}) {
      assertThrows(IllegalArgumentException.class, () -> assignment.setCost(0, 0, cost));
      assertThrows(IllegalArgumentException.class, () -> assignment.solve(cost, 0));
      assertThrows(IllegalArgumentException.class, () -> assignment.solve(0, cost));
    }
    assertThrows(IllegalArgumentException.class, () -> assignment.solve(FORBIDDEN, 0));
    assertThrows(IndexOutOfBoundsException.class, () -> assignment.setCost(0, 3, 1));
    assertThrows(IndexOutOfBoundsException.class, () -> assignment.setCost(2, 0, 1));
  }

  @Test
  void solvingAllocatesNoMemory() {
    SplittableRandom random = new SplittableRandom(9);
    double[][] costs = new double[30][40];
    for (double[] line : costs) {
      for (int j = 0; j < line.length; j++) {
        line[j] = random.nextDouble();
      }
    }
    Assignment assignment = new Assignment(30, 40);
    assertEquals(0, Allocation.bytesOf(() -> solve(assignment, costs, 40, 0.05, 0.05)));
  }
}
