package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import java.io.Closeable;

/**
 * An open USB device.
 *
 * <p>Thread rule: all methods may be called from any thread that is not within a {@link
 * TransferListener}. No call takes much longer than {@link #TIMEOUT_MS}.
 */
public interface UsbTransport extends Closeable {
  /** Milliseconds after which a request is given up. */
  int TIMEOUT_MS = 1000;

  /**
   * Which device it is.
   *
   * @return as it was seen
   */
  UsbDevice device();

  /**
   * The work of its bus.
   *
   * @return what a consumer may do while it waits
   */
  default BusWork work() {
    return BusWork.ELSEWHERE;
  }

  /**
   * The serial number of the device.
   *
   * @return trimmed; empty if it has none
   * @throws CameraProblem if it does not answer
   */
  String serialNumber() throws CameraProblem;

  /**
   * Takes interface 0 of configuration 1 for this program alone.
   *
   * @throws CameraProblem if another program has it, or the device is gone
   */
  void claim() throws CameraProblem;

  /**
   * Sends a vendor request.
   *
   * @param request its number
   * @param value 16 bits
   * @param index 16 bits
   * @param data what goes with it
   * @throws CameraProblem if the device refuses it, does not answer in time, or is gone
   */
  void send(int request, int value, int index, byte... data) throws CameraProblem;

  /**
   * Sends a vendor request that is answered.
   *
   * @param request its number
   * @param value 16 bits
   * @param index 16 bits
   * @param length bytes that the answer has
   * @return the answer, of exactly this length
   * @throws CameraProblem if the device refuses it, answers with less, does not answer in time, or
   *     is gone
   */
  byte[] ask(int request, int value, int index, int length) throws CameraProblem;

  /**
   * Writes to a bulk endpoint and waits until that is done.
   *
   * @param endpoint its address, below 0x80
   * @param data what to write
   * @throws CameraProblem if the device does not take all of it in time, or is gone
   */
  void write(int endpoint, byte... data) throws CameraProblem;

  /**
   * Reads one transfer from a bulk endpoint.
   *
   * @param endpoint its address, 0x80 or more
   * @param most bytes
   * @return the data
   * @throws CameraProblem if nothing came in time, or the device is gone
   */
  byte[] read(int endpoint, int most) throws CameraProblem;

  /**
   * Lifts the halt of an endpoint.
   *
   * @param endpoint its address
   * @throws CameraProblem if the device refuses or is gone
   */
  void clearHalt(int endpoint) throws CameraProblem;

  /**
   * Prepares a transfer.
   *
   * @param endpoint address of a bulk endpoint, 0x80 or more
   * @param listener told of its end
   * @return a transfer that is not started
   */
  BulkTransfer prepare(int endpoint, TransferListener listener);

  /**
   * Frees transfers that are not under way, once the thread that ended them is done with them.
   *
   * @param transfers of this transport
   */
  void free(Iterable<BulkTransfer> transfers);

  /** Closes the device. No transfer may be under way. A second call does nothing. */
  @Override
  void close();
}
