/** A source that waits for the playback clock. */
package haltere.core.playback.internal;
