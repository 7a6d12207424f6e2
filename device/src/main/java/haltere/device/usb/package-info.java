/**
 * Bytes to and from a device over USB: an interface with an implementation over libusb, the ring of
 * transfers, and the bounded queue from its thread to the consumer's. Independent of cameras.
 */
package haltere.device.usb;
