/**
 * Editing of the chain: a card for each stage, fields for settings, undo. {@code ChainEditor}
 * passes each change to the processing thread, between two packets.
 */
package haltere.ui.viewer.chain;
