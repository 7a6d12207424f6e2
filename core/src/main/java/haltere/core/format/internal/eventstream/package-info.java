/**
 * Event Stream ({@code .es}) 2: a header of 16 or 20 bytes, then events of a few bytes each, whose
 * first gives the advance of time and what follows.
 *
 * <p><b>Times.</b> Microseconds since the start of the recording, as the sum of all steps from 0:
 * 64 bits, no wraps. The clock cannot go back, so a recording is one segment. Longer silences are
 * written as bytes that only let time go on (127 us each for DVS), so that a silence of an hour
 * takes 28 MB.
 *
 * <p><b>Pixels.</b> The format's authors put the origin at the bottom left, most of its users read
 * the files as pictures with the origin at the top left. Haltere takes the rows to count from the
 * top, as for the other formats of this kind, and turns them over; plain exports give the file's
 * own numbers.
 *
 * <p><b>What is not read.</b> The exposure measurements of ATIS files, colour events and generic
 * messages are counted as other data.
 */
package haltere.core.format.internal.eventstream;
