/**
 * USB devices that exist in a test only: what a camera's firmware does, in Java, and two ways to
 * plug it in. {@link haltere.testing.usb.MemoryBus} stands in for libusb; {@link
 * haltere.testing.usb.UsbEmulator} stands in for the kernel below the unmodified libusb.
 */
package haltere.testing.usb;
