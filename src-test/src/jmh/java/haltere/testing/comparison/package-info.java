/** Our side of the comparison with other programs, see {@code src-test/compare/compare.py}. */
package haltere.testing.comparison;
