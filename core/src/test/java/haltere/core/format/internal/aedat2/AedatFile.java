package haltere.core.format.internal.aedat2;

import haltere.core.event.EventPacket;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** Builds files byte by byte, as no writer of ours would. */
final class AedatFile {
  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final DataOutputStream out = new DataOutputStream(bytes);

  static AedatFile empty() {
    return new AedatFile();
  }

  static AedatFile version2() {
    return new AedatFile().text("#!AER-DAT2.0\r\n");
  }

  static AedatFile version1() {
    return new AedatFile().text("#!AER-DAT1.0\r\n");
  }

  AedatFile text(String text) {
    return raw(text.getBytes(StandardCharsets.ISO_8859_1));
  }

  AedatFile raw(byte[] raw) {
    bytes.writeBytes(raw);
    return this;
  }

  /** A record of AEDAT-2.0. */
  AedatFile record(int word, int time) {
    try {
      out.writeInt(word);
      out.writeInt(time);
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    return this;
  }

  /** A record of AEDAT-1.0. */
  AedatFile narrow(int word, int time) {
    try {
      out.writeShort(word);
      out.writeInt(time);
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    return this;
  }

  /** A DVS128 event. */
  AedatFile dvs128(int time, int x, int y, boolean on) {
    return record(y << 8 | 127 - x << 1 | (on ? 0 : 1), time);
  }

  /** An event of a DAVIS240. */
  AedatFile davis240(int time, int x, int y, boolean on) {
    return record(y << 22 | 239 - x << 12 | (on ? 1 : 0) << 11, time);
  }

  AedatFile narrow(EventPacket packet) {
    for (int i = 0; i < packet.size(); i++) {
      narrow(
          packet.y(i) << 8 | 127 - packet.x(i) << 1 | (packet.isOn(i) ? 0 : 1),
          (int) packet.timeUs(i));
    }
    return this;
  }

  byte[] toBytes() {
    return bytes.toByteArray();
  }

  Path in(Path folder, String name) throws IOException {
    return Files.write(folder.resolve(name), toBytes());
  }
}
