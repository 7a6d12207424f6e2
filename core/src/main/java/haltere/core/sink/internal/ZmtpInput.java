package haltere.core.sink.internal;

import java.io.BufferedInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.net.ProtocolException;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.TimeUnit;

/**
 * Input of a ZMTP peer. A frame that states more than {@value #MAX_FRAME_BYTES} bytes is rejected
 * before memory is allocated for it.
 *
 * <p>Thread rule: one thread.
 */
final class ZmtpInput {
  /** Longer than any topic. */
  static final int MAX_FRAME_BYTES = 4096;

  /**
   * A frame.
   *
   * @param command the name of the command; empty for part of a message
   * @param data the bytes of the message, or those after the command's name
   */
  record ZmtpFrame(String command, byte[] data) {}

  private final Socket socket;
  private final InputStream in;
  private final long deadlineNanos;
  private boolean unlimited;

  /** Input with a time limit for reads until it is removed. */
  ZmtpInput(Socket socket, int limitMs) throws IOException {
    this.socket = socket;
    in = new BufferedInputStream(socket.getInputStream());
    deadlineNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(limitMs);
  }

  /** Removes the time limit of reads. */
  void removeTimeLimit() throws IOException {
    unlimited = true;
    socket.setSoTimeout(0);
  }

  ZmtpFrame readFrame() throws IOException {
    int flags = read();
    long bytes =
        (flags & ZmtpProtocol.LONG) == 0 ? read() : ByteBuffer.wrap(read(Long.BYTES)).getLong();
    if (bytes < 0 || bytes > MAX_FRAME_BYTES) {
      throw new ProtocolException("a frame of " + bytes + " bytes");
    }
    ByteBuffer body = ByteBuffer.wrap(read((int) bytes));
    String command = "";
    if ((flags & ZmtpProtocol.COMMAND) != 0) {
      command = text(body, bytes == 0 ? 0 : body.get() & 0xFF);
    }
    byte[] data = new byte[body.remaining()];
    body.get(data);
    return new ZmtpFrame(command, data);
  }

  /** Reads a text of a number of bytes. */
  static String text(ByteBuffer from, int bytes) throws ProtocolException {
    if (bytes < 0 || bytes > from.remaining()) {
      throw new ProtocolException("a text of " + bytes + " bytes where there are fewer");
    }
    byte[] text = new byte[bytes];
    from.get(text);
    return new String(text, StandardCharsets.ISO_8859_1);
  }

  /** Reads a number of bytes. */
  byte[] read(int bytes) throws IOException {
    byte[] all = new byte[bytes];
    for (int i = 0; i < bytes; i++) {
      all[i] = (byte) read();
    }
    return all;
  }

  private int read() throws IOException {
    if (!unlimited) {
      long leftMs = TimeUnit.NANOSECONDS.toMillis(deadlineNanos - System.nanoTime());
      if (leftMs <= 0) {
        throw new SocketTimeoutException("too late");
      }
      socket.setSoTimeout((int) leftMs);
    }
    int next = in.read();
    if (next < 0) {
      throw new EOFException("it disconnected");
    }
    return next;
  }
}
