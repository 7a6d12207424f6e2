/**
 * Bytes to and from a device over USB: an interface with one implementation over libusb, the ring
 * of transfers, and the bounded hand-over from its thread to the consumer's. Knows no camera.
 */
package haltere.device.usb;
