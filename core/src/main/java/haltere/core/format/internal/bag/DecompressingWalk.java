package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Payload;
import haltere.core.format.internal.compression.ZstdPayload;
import java.io.IOException;
import java.io.InterruptedIOException;

/**
 * A walk that decompresses individually compressed messages ({@code compression_mode: message} of
 * rosbag2). A ROS 2 message begins with its serialisation, which differs from the start of a
 * Zstandard frame.
 */
final class DecompressingWalk implements MessageWalk {
  private static final int FRAME = 0xfd2f_b528;
  private static final int NAME_BYTES = 4;

  /** Size of a message with unknown size. */
  private static final long ANY_SIZE = Long.MAX_VALUE / 2;

  private final MessageWalk walk;
  private final MessageBody compressed = new MessageBody();
  private ZstdPayload frame;
  private boolean decompressing;

  /**
   * A walk.
   *
   * @param walk walk through the stored messages; closed with this one
   */
  DecompressingWalk(MessageWalk walk) {
    this.walk = walk;
  }

  /**
   * {@inheritDoc} All readers of a bag pass here, so an interrupt is noticed here.
   *
   * @throws InterruptedIOException if the thread is interrupted
   */
  @Override
  public boolean find() throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new InterruptedIOException("interrupted while reading a bag");
    }
    while (walk.find()) {
      try {
        decompressing = walk.topic().cdr() && isFrame(walk.payload(), walk.size());
        if (decompressing) {
          open();
        }
        return true;
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    decompressing = false;
    return false;
  }

  private static boolean isFrame(Payload payload, long size)
      throws IOException, DamagedPacketException {
    return size >= NAME_BYTES
        && payload.gather(NAME_BYTES)
        && LittleEndian.getInt(payload.data(), payload.from()) == FRAME;
  }

  private void open() throws IOException, DamagedPacketException {
    frame = frame == null ? new ZstdPayload(compressed) : frame;
    compressed.open(walk.payload(), walk.size());
    frame.open(0, walk.size());
  }

  @Override
  public BagTopic topic() {
    return walk.topic();
  }

  @Override
  public Payload payload() {
    return decompressing ? frame : walk.payload();
  }

  @Override
  public long size() {
    if (!decompressing) {
      return walk.size();
    }
    return frame.claimedBytes() < 0 ? ANY_SIZE : frame.claimedBytes();
  }

  @Override
  public String compression() {
    return decompressing ? "zstd" : walk.compression();
  }

  @Override
  public long recordedNs() {
    return walk.recordedNs();
  }

  @Override
  public long offset(long done) {
    if (!decompressing) {
      return walk.offset(done);
    }
    double part = Math.min(1.0, done / Math.max(1.0, size()));
    return walk.offset((long) (part * walk.size()));
  }

  @Override
  public long position() {
    return walk.position();
  }

  @Override
  public void pass(long unused) throws IOException {
    walk.pass(decompressing ? compressed.left() : unused);
    decompressing = false;
  }

  @Override
  public void damaged(DamagedPacketException damage) throws IOException {
    decompressing = false;
    walk.damaged(damage);
  }

  @Override
  public void save(long[] state, int at) {
    walk.save(state, at);
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    decompressing = false;
    walk.restore(state, at);
  }

  @Override
  public void close() throws IOException {
    if (frame != null) {
      frame.close();
    }
    walk.close();
  }
}
