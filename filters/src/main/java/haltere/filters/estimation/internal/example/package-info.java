/**
 * The two worked examples of Casper (2012), "Kalman filtering": a falling weight and a weight on a
 * spring, both measured on video. They estimate simulated measurements or a user's own, and show
 * how the classes of {@code haltere.filters.estimation} are put together. Units are metres,
 * seconds, radians.
 */
package haltere.filters.estimation.internal.example;
