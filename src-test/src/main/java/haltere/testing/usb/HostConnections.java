package haltere.testing.usb;

import java.io.EOFException;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * The sockets of one device: libusbemu.so connects each time that the device's file is opened. A
 * message has 40 bytes (type, length of what follows, number, three values) in the machine's order,
 * and what follows.
 */
final class HostConnections {
  private static final int HEAD_BYTES = 40;
  private static final int SUBMIT = 1;
  private static final int DISCARD = 2;
  private static final int CALL = 3;
  private static final int CONTROL_TRANSFER = 2;
  private static final int CLEAR_HALT = 21;
  private static final int TO_HOST = 0x80;

  /** Work of a thread until a channel closes. */
  interface Body {
    void run() throws IOException;
  }

  private final EmulatedDevice device;
  private final ServerSocketChannel server;
  private final List<SocketChannel> hosts = new CopyOnWriteArrayList<>();

  HostConnections(EmulatedDevice device, Path socket) throws IOException {
    this.device = device;
    server = listen(socket);
    daemon(
        "usb-device-" + device.number(),
        () -> {
          while (true) {
            SocketChannel host = server.accept();
            hosts.add(host);
            daemon("usb-host-of-" + device.number(), () -> serve(host));
          }
        });
  }

  /** The device is unplugged. */
  void close() throws IOException {
    server.close();
    for (SocketChannel host : hosts) {
      synchronized (host) {
        host.close();
      }
    }
  }

  private void serve(SocketChannel host) throws IOException {
    Map<Long, EmulatedEndpoint.Transfer> transfers = new ConcurrentHashMap<>();
    ByteBuffer head = ByteBuffer.allocate(HEAD_BYTES).order(ByteOrder.nativeOrder());
    try {
      while (true) {
        read(host, head.clear());
        head.flip();
        int type = head.getInt();
        int length = head.getInt();
        long id = head.getLong();
        long first = head.getLong();
        long second = head.getLong();
        int room = (int) head.getLong();
        ByteBuffer body = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
        read(host, body);
        body.flip();
        switch (type) {
          case SUBMIT -> {
            if (first == CONTROL_TRANSFER) {
              control(host, id, body);
            } else if ((second & TO_HOST) != 0) {
              submit(host, transfers, id, (int) second & 0xff, room);
            } else {
              device.firmware().written((int) second & 0xff, body.array());
              answer(host, SUBMIT, id, 0, length, new byte[0], 0);
            }
          }
          case DISCARD -> {
            EmulatedEndpoint.Transfer transfer = transfers.remove(id);
            if (transfer != null) {
              device.discard(transfer);
            }
          }
          case CALL -> {
            if (first == CLEAR_HALT) {
              device.halt((int) second & 0xff, false);
            }
            int result = device.firmware().systemCall((int) first);
            answer(host, CALL, id, result, 0, new byte[0], 0);
          }
          default -> throw new IOException("message of type " + type);
        }
      }
    } finally {
      hosts.remove(host);
      host.close();
      transfers.values().forEach(device::discard);
    }
  }

  private void submit(
      SocketChannel host,
      Map<Long, EmulatedEndpoint.Transfer> transfers,
      long id,
      int endpoint,
      int room) {
    EmulatedEndpoint.Transfer transfer =
        new EmulatedEndpoint.Transfer(
            room,
            (error, data, length) -> {
              transfers.remove(id);
              return answer(host, SUBMIT, id, error, length, data, length);
            });
    transfers.put(id, transfer);
    device.submit(endpoint, transfer);
  }

  private void control(SocketChannel host, long id, ByteBuffer setup) {
    if (device.isDeaf()) {
      return;
    }
    int type = setup.get() & 0xff;
    int request = setup.get() & 0xff;
    int value = setup.getShort() & 0xffff;
    int index = setup.getShort() & 0xffff;
    int length = setup.getShort() & 0xffff;
    byte[] data = new byte[setup.remaining()];
    setup.get(data);
    byte[] answer = device.control(new ControlRequest(type, request, value, index, length, data));
    if (answer == null) {
      answer(host, SUBMIT, id, EmulatedDevice.EPIPE, 0, new byte[0], 0);
    } else if ((type & TO_HOST) == 0) {
      answer(host, SUBMIT, id, 0, data.length, new byte[0], 0);
    } else {
      byte[] sent = Arrays.copyOf(answer, Math.min(answer.length, length));
      answer(host, SUBMIT, id, 0, sent.length, sent, sent.length);
    }
  }

  private static boolean answer(
      SocketChannel host, int type, long id, long first, long second, byte[] data, int length) {
    ByteBuffer message = ByteBuffer.allocate(HEAD_BYTES + length).order(ByteOrder.nativeOrder());
    message.putInt(type).putInt(length).putLong(id).putLong(first).putLong(second).putLong(0);
    message.put(data, 0, length).flip();
    synchronized (host) {
      try {
        write(host, message);
        return true;
      } catch (IOException gone) {
        return false; // the driver has closed the device, or it was unplugged
      }
    }
  }

  static void daemon(String name, Body body) {
    Thread thread =
        new Thread(
            () -> {
              try {
                body.run();
              } catch (IOException closed) {
                // The end of what this thread serves.
              }
            },
            name);
    thread.setDaemon(true);
    thread.start();
  }

  static ServerSocketChannel listen(Path socket) throws IOException {
    Files.deleteIfExists(socket);
    return ServerSocketChannel.open(StandardProtocolFamily.UNIX)
        .bind(UnixDomainSocketAddress.of(socket));
  }

  private static void read(SocketChannel channel, ByteBuffer into) throws IOException {
    while (into.hasRemaining()) {
      if (channel.read(into) < 0) {
        throw new EOFException();
      }
    }
  }

  static void write(SocketChannel channel, ByteBuffer from) throws IOException {
    while (from.hasRemaining()) {
      channel.write(from);
    }
  }
}
