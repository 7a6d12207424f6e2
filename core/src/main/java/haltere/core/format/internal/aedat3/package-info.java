/**
 * AEDAT-3.0 and AEDAT-3.1, the formats of cAER: read only.
 *
 * <p><b>Layout.</b> A text header, then little-endian packets, each with a header of 28 bytes and
 * events of one kind. Polarity events are read; of special events, frames, inertial samples and
 * other kinds each counts as one of {@link haltere.core.format.Violation#OTHER_DATA}, as do
 * polarity events that are marked as not valid, and those of a second camera. Rows count from the
 * top.
 *
 * <p><b>Times.</b> Microseconds of the camera's clock: 31 bits in the event and 31 more in the
 * packet's header, so it neither wraps nor is negative.
 */
package haltere.core.format.internal.aedat3;
