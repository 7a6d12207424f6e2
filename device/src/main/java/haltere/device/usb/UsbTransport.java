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
  /** Timeout of a request in milliseconds. */
  int TIMEOUT_MS = 1000;

  /**
   * The device.
   *
   * @return as listed before opening
   */
  UsbDevice device();

  /**
   * The event handling of its bus.
   *
   * @return for a waiting consumer
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
   * Claims interface 0 of configuration 1 for this program.
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
   * @param data its data
   * @throws CameraProblem if the device rejects it, does not answer in time, or is gone
   */
  void send(int request, int value, int index, byte... data) throws CameraProblem;

  /**
   * Sends a vendor request with an answer.
   *
   * @param request its number
   * @param value 16 bits
   * @param index 16 bits
   * @param length bytes of the answer
   * @return the answer, of exactly this length
   * @throws CameraProblem if the device rejects it, answers with less, does not answer in time, or
   *     is gone
   */
  byte[] query(int request, int value, int index, int length) throws CameraProblem;

  /**
   * Writes to a bulk endpoint and waits for completion.
   *
   * @param endpoint its address, below 0x80
   * @param data the data
   * @throws CameraProblem if the device does not accept all of it in time, or is gone
   */
  void write(int endpoint, byte... data) throws CameraProblem;

  /**
   * Reads one transfer from a bulk endpoint.
   *
   * @param endpoint its address, 0x80 or more
   * @param maxBytes maximum number of bytes
   * @return the data
   * @throws CameraProblem if no data arrived in time, or the device is gone
   */
  byte[] read(int endpoint, int maxBytes) throws CameraProblem;

  /**
   * Clears the halt of an endpoint.
   *
   * @param endpoint its address
   * @throws CameraProblem if the device rejects it or is gone
   */
  void clearHalt(int endpoint) throws CameraProblem;

  /**
   * Prepares a transfer.
   *
   * @param endpoint address of a bulk endpoint, 0x80 or more
   * @param listener receives its end
   * @return a transfer that is not started
   */
  BulkTransfer prepare(int endpoint, TransferListener listener);

  /**
   * Frees inactive transfers when the thread that ended them no longer uses them.
   *
   * @param transfers of this transport
   */
  void free(Iterable<BulkTransfer> transfers);

  /** Closes the device. No transfer may be active. A second call has no effect. */
  @Override
  void close();
}
