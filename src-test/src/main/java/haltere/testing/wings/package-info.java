/** Evaluation of the wing tracker on simulated flies, scene by scene and over many scenes. */
package haltere.testing.wings;
