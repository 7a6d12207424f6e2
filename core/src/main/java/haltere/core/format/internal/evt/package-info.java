/**
 * Prophesee RAW: a text header, then unframed words of EVT2, EVT2.1 or EVT3, little-endian.
 *
 * <p><b>Times.</b> Microseconds of the camera's clock: nothing is subtracted, so that a recording
 * begins at any time (OpenEB can shift times to begin near 0; evt3, evutils, expelliarmus and faery
 * do not). The words have the time in two parts; the high part has words of its own. EVT2 and
 * EVT2.1 have 34 bits, which wrap after 4 h 46 min, EVT3 24 bits, which wrap after 16.8 s; decoders
 * count the wraps ({@code EvtClock}).
 *
 * <p><b>Wraps and restarts.</b> A high part that decreases by half of its range or more (EVT3), or
 * from the last second of the range to the first (EVT2, EVT2.1), is a wrap. After any other
 * decrease time goes back: the events after it are a new segment. A bit error in the highest bits
 * of an EVT3 high part cannot be distinguished from a wrap. A gap of more than a wrap period
 * without any time word cannot be detected; cameras and Haltere's writers send time words
 * continuously. Events before the first high part have no time and are skipped. In EVT3 a new high
 * part sets the low part to 0.
 *
 * <p><b>Pixels.</b> Rows count from the top in the words and from the bottom in packets. The size
 * of the sensor comes from the header's lines {@code format} or {@code geometry}; older headers
 * have neither, see {@link haltere.core.format.internal.evt.PropheseeSensor}.
 *
 * <p><b>What is not read.</b> External triggers, inertial samples and monitoring words are counted
 * as other data.
 */
package haltere.core.format.internal.evt;
