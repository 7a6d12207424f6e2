package haltere.core.format.internal.bag;

import haltere.core.format.internal.packed.DamagedPacketException;
import haltere.core.format.internal.packed.LittleEndian;
import haltere.core.format.internal.packed.Payload;
import haltere.core.format.internal.packed.ZstdPayload;
import java.io.IOException;

/**
 * A walk whose messages are unpacked where they are packed one by one ({@code compression_mode:
 * message} of rosbag2). A message of ROS 2 begins with the name of its serialisation, which is
 * never what a Zstandard frame begins with.
 */
final class UnpackingWalk implements MessageWalk {
  private static final int FRAME = 0xfd2f_b528;
  private static final int NAME_BYTES = 4;

  /** Of a message that does not say how long it will be. */
  private static final long ANY_SIZE = Long.MAX_VALUE / 2;

  private final MessageWalk walk;
  private final MessageBody packed = new MessageBody();
  private ZstdPayload frame;
  private boolean unpacking;

  /**
   * A walk.
   *
   * @param walk through the messages as they are; closed with this one
   */
  UnpackingWalk(MessageWalk walk) {
    this.walk = walk;
  }

  @Override
  public boolean find() throws IOException {
    while (walk.find()) {
      try {
        unpacking = walk.topic().cdr() && isFrame(walk.payload(), walk.size());
        if (unpacking) {
          open();
        }
        return true;
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    unpacking = false;
    return false;
  }

  private static boolean isFrame(Payload payload, long size)
      throws IOException, DamagedPacketException {
    return size >= NAME_BYTES
        && payload.gather(NAME_BYTES)
        && LittleEndian.getInt(payload.data(), payload.from()) == FRAME;
  }

  private void open() throws IOException, DamagedPacketException {
    frame = frame == null ? new ZstdPayload(packed) : frame;
    packed.open(walk.payload(), walk.size());
    frame.open(0, walk.size());
  }

  @Override
  public BagTopic topic() {
    return walk.topic();
  }

  @Override
  public Payload payload() {
    return unpacking ? frame : walk.payload();
  }

  @Override
  public long size() {
    if (!unpacking) {
      return walk.size();
    }
    return frame.claimedBytes() < 0 ? ANY_SIZE : frame.claimedBytes();
  }

  @Override
  public String compression() {
    return unpacking ? "zstd" : walk.compression();
  }

  @Override
  public long recordedNs() {
    return walk.recordedNs();
  }

  @Override
  public long offset(long done) {
    if (!unpacking) {
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
    walk.pass(unpacking ? packed.left() : unused);
    unpacking = false;
  }

  @Override
  public void damaged(DamagedPacketException damage) throws IOException {
    unpacking = false;
    walk.damaged(damage);
  }

  @Override
  public void save(long[] state, int at) {
    walk.save(state, at);
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    unpacking = false;
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
