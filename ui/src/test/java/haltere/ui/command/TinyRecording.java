package haltere.ui.command;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** AEDAT-2 files of a DVS128, written byte by byte as its specification says. */
final class TinyRecording {
  private static final String HEADER =
      "#!AER-DAT2.0\r\n# AEChip: ch.unizh.ini.jaer.chip.retina.DVS128\r\n";

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
  private final DataOutputStream data = new DataOutputStream(bytes);

  TinyRecording() {
    try {
      data.write(HEADER.getBytes(StandardCharsets.US_ASCII));
    } catch (IOException inMemory) {
      throw new UncheckedIOException(inMemory);
    }
  }

  static int headerBytes() {
    return HEADER.length();
  }

  /** Adds an event; y counts up. */
  TinyRecording event(int timeUs, int x, int y, boolean on) {
    try {
      data.writeInt(y << 8 | (127 - x) << 1 | (on ? 0 : 1));
      data.writeInt(timeUs);
    } catch (IOException inMemory) {
      throw new UncheckedIOException(inMemory);
    }
    return this;
  }

  byte[] bytes() {
    return bytes.toByteArray();
  }

  /** Writes the file. */
  Path write(Path file) throws IOException {
    return Files.write(file, bytes());
  }

  /** A hundred events, 1 ms apart from 5 s on, on a diagonal, every third of them OFF. */
  static TinyRecording hundred() {
    TinyRecording recording = new TinyRecording();
    for (int i = 0; i < 100; i++) {
      recording.event(5_000_000 + 1000 * i, i, i, i % 3 != 0);
    }
    return recording;
  }
}
