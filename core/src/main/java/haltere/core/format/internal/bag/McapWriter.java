package haltere.core.format.internal.bag;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.ZstdPacker;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.lang.invoke.VarHandle;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes events as messages {@code dvs_msgs/msg/EventArray} of ROS 2, which more programs read than
 * encoded packets, and which have exact times. A message holds at most {@value #MAX_EVENTS} events
 * and 10 ms; chunks are compressed with Zstandard.
 *
 * <p>Times have signed 32 bits of seconds: times more than 68 years from 0 are rejected.
 */
final class McapWriter implements RecordingWriter {
  /** Maximum number of events of a message. */
  static final int MAX_EVENTS = 8192;

  private static final long MESSAGE_US = 10_000;
  private static final int CHUNK_BYTES = 1 << 20;
  private static final int FIRST_EVENT_BYTES = 13;
  private static final int EVENT_BYTES = 16;
  private static final int ZSTD_LEVEL = 1;
  private static final long US_PER_S = 1_000_000;
  private static final long NS_PER_US = 1_000;
  private static final long MAX_US = (1L << 31) * US_PER_S - 1;
  private static final int CDR_LITTLE_ENDIAN = 0x0100;
  private static final int NO_MESSAGE = -1;
  private static final String FRAME = "camera";

  private final Path path;
  private final AtomicFile file;
  private final McapSummary summary;
  private final ZstdPacker compressor = new ZstdPacker(ZSTD_LEVEL);
  private final McapOutput chunk = new McapOutput();
  private final SensorGeometry geometry;

  private int lengthAt = NO_MESSAGE;
  private int countAt;
  private int count;
  private long number;
  private long firstUs;
  private long lastUs;
  private long secondUs = Long.MAX_VALUE;
  private int second;
  private long outside;

  McapWriter(Path path, WriteOptions options) throws IOException {
    this.path = path;
    geometry = options.geometry();
    file = AtomicFile.create(path, options.overwrite());
    try {
      summary = new McapSummary(file, options.metadata());
    } catch (IOException e) {
      file.close();
      throw e;
    }
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    file.requireUncommitted();
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int width = geometry.width();
    int top = geometry.height() - 1;
    VarHandle ints = LittleEndian.INT;
    VarHandle longs = LittleEndian.LONG;
    for (int i = 0; i < size; i++) {
      long timeUs = times[i];
      int address = addresses[i];
      int x = EventAddress.x(address);
      int row = top - EventAddress.y(address);
      if (x >= width || row < 0) {
        outside++;
        continue;
      }
      if (timeUs > MAX_US || timeUs < -MAX_US) {
        throw tooFar(timeUs);
      }
      if (lengthAt == NO_MESSAGE
          || count == MAX_EVENTS
          || timeUs - firstUs >= MESSAGE_US
          || timeUs < lastUs) {
        endMessage();
        startMessage(timeUs);
      }
      if (timeUs - secondUs >= US_PER_S || timeUs < secondUs) {
        second = (int) Math.floorDiv(timeUs, US_PER_S);
        secondUs = second * US_PER_S;
      }
      lastUs = timeUs;
      long nanoseconds = (timeUs - secondUs) * NS_PER_US;
      long time = second & 0xffff_ffffL | nanoseconds << 32;
      int pixel = row << 16 | x;
      byte on = (byte) (address & EventAddress.ON_BIT);
      if (count++ == 0) {
        int at = chunk.grow(FIRST_EVENT_BYTES);
        byte[] bytes = chunk.bytes();
        ints.set(bytes, at, pixel);
        longs.set(bytes, at + 4, time);
        bytes[at + 12] = on;
      } else {
        int at = chunk.grow(EVENT_BYTES);
        byte[] bytes = chunk.bytes();
        bytes[at] = 0;
        ints.set(bytes, at + 1, pixel);
        bytes[at + 5] = 0;
        bytes[at + 6] = 0;
        longs.set(bytes, at + 7, time);
        bytes[at + 15] = on;
      }
    }
  }

  private RecordingProblem tooFar(long timeUs) {
    return new RecordingProblem(
        path,
        "an event at "
            + timeUs
            + " us is more than 68 years from 0, the limit of ROS 2 messages; choose "
            + "another format");
  }

  private void startMessage(long timeUs) throws IOException {
    if (chunk.size() >= CHUNK_BYTES) {
      endChunk();
    }
    if (chunk.size() == 0) {
      summary.putTopic(chunk);
    }
    firstUs = timeUs;
    count = 0;
    long timeNs = Math.max(0, timeUs * NS_PER_US);
    summary.message(timeNs, chunk.size());
    lengthAt = chunk.start(McapRecord.MESSAGE);
    chunk.u16(McapSummary.CHANNEL).u32(number++).u64(timeNs).u64(timeNs);
    chunk.u32(CDR_LITTLE_ENDIAN);
    int start = chunk.size();
    chunk.u32(Math.floorDiv(timeUs, US_PER_S));
    chunk.u32(Math.floorMod(timeUs, US_PER_S) * NS_PER_US);
    chunk.text(FRAME + "\0");
    while ((chunk.size() - start & 3) != 0) {
      chunk.u8(0);
    }
    chunk.u32(geometry.height()).u32(geometry.width());
    countAt = chunk.size();
    chunk.u32(0);
  }

  private void endMessage() {
    if (lengthAt != NO_MESSAGE) {
      LittleEndian.putInt(chunk.bytes(), countAt, count);
      chunk.end(lengthAt);
      lengthAt = NO_MESSAGE;
    }
  }

  private void endChunk() throws IOException {
    endMessage();
    if (chunk.size() > 0) {
      summary.writeChunk(chunk, compressor);
      chunk.clear();
    }
  }

  @Override
  public List<String> losses() {
    return WriterLosses.outside(outside, geometry);
  }

  @Override
  public void finish() throws IOException {
    file.requireUncommitted();
    endChunk();
    summary.finish();
    file.commit();
  }

  @Override
  public void close() throws IOException {
    compressor.close();
    file.close();
  }
}
