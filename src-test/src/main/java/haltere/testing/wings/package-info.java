/** How well the wings of simulated flies are tracked, scene by scene and over many of them. */
package haltere.testing.wings;
