package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import org.usb4java.LibUsb;

/** Converts libusb's error numbers to problems. */
final class LibusbProblem {
  private LibusbProblem() {}

  /** Returns a result that is not an error; throws otherwise. */
  static int check(int result, String attempt) throws CameraProblem {
    if (result < 0) {
      throw of(result, attempt);
    }
    return result;
  }

  /** The problem for an error number. */
  static CameraProblem of(int error, String attempt) {
    return switch (error) {
      case LibUsb.ERROR_PIPE -> new CameraProblem(Kind.REFUSED, "the camera refused to " + attempt);
      case LibUsb.ERROR_TIMEOUT ->
          new CameraProblem(Kind.TIMED_OUT, "the camera did not answer when asked to " + attempt);
      case LibUsb.ERROR_NO_DEVICE ->
          new CameraProblem(Kind.GONE, "the camera was unplugged; it could not " + attempt);
      case LibUsb.ERROR_BUSY ->
          new CameraProblem(Kind.BUSY, "another program uses the camera; close that one first");
      default ->
          new CameraProblem(Kind.BROKEN, "could not " + attempt + ": " + LibUsb.strError(error));
    };
  }
}
