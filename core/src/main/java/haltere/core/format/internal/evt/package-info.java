/**
 * Prophesee RAW: a text header, then words of EVT2, EVT2.1 or EVT3 without any frame,
 * little-endian.
 *
 * <p><b>Times.</b> Microseconds of the camera's clock, as the words say it: nothing is subtracted,
 * so a recording begins at whatever the clock stood at (OpenEB can shift times to begin near 0;
 * evt3, evutils, expelliarmus and faery do not). The words give the clock in two parts; the high
 * part comes in words of its own. EVT2 and EVT2.1 hold 34 bits, a turn of 4 h 46 min, EVT3 24 bits,
 * a turn of 16.8 s; decoders count the turns ({@code EvtClock}).
 *
 * <p><b>Wraps and restarts.</b> A high part that falls by half of its range or more (EVT3), or from
 * the last second of the range to the first (EVT2, EVT2.1), is a new turn. Any other fall makes
 * time go back: the events after it are a new segment. A bit error in the highest bits of an EVT3
 * high part looks like a wrap, and nothing in the words tells the difference. A silence of more
 * than a turn without any word of time cannot be seen; cameras send such words all the time, and so
 * do our writers. Events before the first high part have no time and are left out. In EVT3 a new
 * high part sets the low part to 0.
 *
 * <p><b>Pixels.</b> Rows count from the top in the words and from the bottom in packets. The size
 * of the sensor comes from the header's lines {@code format} or {@code geometry}; older headers
 * have neither, see {@link haltere.core.format.internal.evt.PropheseeSensor}.
 *
 * <p><b>What is not read.</b> External triggers, inertial samples and monitoring words are counted
 * as other data.
 */
package haltere.core.format.internal.evt;
