/**
 * How well tracks follow the truth: the published metrics, computed from rows of truth and rows of
 * tracks. Positions are in any one unit, pixels or metres, and so are the results.
 */
package haltere.testing.evaluation;
