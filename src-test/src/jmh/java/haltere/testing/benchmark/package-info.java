/** One benchmark per stage, the baseline beside the candidates. */
package haltere.testing.benchmark;
