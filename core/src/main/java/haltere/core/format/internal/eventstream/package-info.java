/**
 * Event Stream ({@code .es}) 2: a header of 16 or 20 bytes, then events of a few bytes each, the
 * first of which states the time step and the data that follow.
 *
 * <p><b>Times.</b> Microseconds since the start of the recording, as the sum of all steps from 0:
 * 64 bits, no wraps. The clock cannot go back, so a recording is one segment. Longer gaps are
 * written as bytes that only advance time (127 us each for DVS), so that a gap of an hour takes 28
 * MB.
 *
 * <p><b>Pixels.</b> The format's authors put the origin at the bottom left, most of its users read
 * the files as images with the origin at the top left. Haltere assumes rows from the top, as for
 * similar formats, and flips them; plain exports have the file's own numbers.
 *
 * <p><b>What is not read.</b> The exposure measurements of ATIS files, colour events and generic
 * messages are counted as other data.
 */
package haltere.core.format.internal.eventstream;
