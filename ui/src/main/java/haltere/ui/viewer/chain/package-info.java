/**
 * The chain of filters as a person sees and changes it: a card for each stage, fields for its
 * settings, what can be taken back. {@code ChainEditor} brings each change to the processing
 * thread, between two packets.
 */
package haltere.ui.viewer.chain;
