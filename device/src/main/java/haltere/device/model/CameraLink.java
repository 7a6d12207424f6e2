package haltere.device.model;

import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.ReceivedBuffers;
import haltere.device.usb.TransferRing;
import haltere.device.usb.UsbTransport;

/**
 * A connection to a camera: opened, claimed and set up, then streaming, then closed.
 *
 * <p>Thread rule: one thread at a time; {@link #buffers} may be called by any.
 */
final class CameraLink {
  private static final long DEFAULT_MAX_BYTES = 8 << 20;
  private static final int DEFAULT_MAX_BUFFERS = 2048;

  private final CameraDriver driver;
  private final UsbTransport transport;
  private final ReceivedBuffers buffers;
  private final WireDecoder decoder;
  private final TransferRing ring;
  private boolean running;
  private boolean closed;

  /**
   * Sets a camera up.
   *
   * @param driver of the camera
   * @param transport open and claimed; closed with this, and if this fails
   * @param options options of its event stream
   */
  CameraLink(CameraDriver driver, UsbTransport transport, CameraOptions options)
      throws CameraProblem {
    this.driver = driver;
    this.transport = transport;
    DataEndpoint from = driver.endpoint();
    int transfers = options.transfers() == 0 ? from.defaultTransfers() : options.transfers();
    int bytes = options.bufferBytes() == 0 ? from.defaultBufferBytes() : options.bufferBytes();
    int waiting =
        options.waitingBuffers() == 0
            ? (int) Math.min(DEFAULT_MAX_BUFFERS, Math.max(8, DEFAULT_MAX_BYTES / bytes))
            : options.waitingBuffers();
    try {
      driver.connect(transport);
      decoder = driver.newDecoder(options.samples());
      buffers =
          new ReceivedBuffers(
              transfers,
              waiting,
              bytes,
              options.whenFull(),
              decoder::droppedWords,
              transport.work());
      ring = new TransferRing(transport, from.address(), transfers, buffers);
    } catch (CameraProblem | RuntimeException problem) {
      driver.disconnect();
      transport.close();
      throw problem;
    }
  }

  ReceivedBuffers buffers() {
    return buffers;
  }

  WireDecoder decoder() {
    return decoder;
  }

  void recover() {
    ring.recover();
  }

  /** Starts the events of the camera. */
  void start() throws CameraProblem {
    running = true;
    driver.start(ring::start);
  }

  /**
   * Ends all transfers and closes the device; received data can still be read. A transfer that does
   * not end within seconds keeps the device and its memory, since libusb may still write to it.
   */
  void close() {
    if (closed) {
      return;
    }
    closed = true;
    buffers.end();
    if (running && !buffers.isAtEndOfDevice()) {
      try {
        driver.stop();
      } catch (CameraProblem ignored) {
        // it is closed anyway, and reconfigured when it is opened
      }
    }
    driver.disconnect();
    if (ring.stop()) {
      transport.close();
    }
  }
}
