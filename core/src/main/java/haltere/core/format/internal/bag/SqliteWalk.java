package haltere.core.format.internal.bag;

import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;

/**
 * The messages of a ROS 2 bag in an SQLite file, by their numbers, which is the order in which they
 * were recorded. The pages of a file are unordered, so that a message's position in the file is
 * estimated from its number.
 */
final class SqliteWalk implements MessageWalk {
  private final SqliteFile file;
  private final SqliteTable messages;
  private final long firstNumber;
  private final long lastNumber;
  private final BagTopics topics;
  private final Wanted wanted;
  private final ViolationCounts violations;

  private boolean found;
  private boolean ended;
  private long recordedNs;
  private long size;
  private BagTopic topic;

  /**
   * A walk.
   *
   * @param file the bag
   * @param root first page of its table of messages
   * @param lastNumber the highest number of a message
   * @param topics all topics
   * @param wanted selects the messages at which it stops
   * @param violations counts damage
   */
  SqliteWalk(
      SqliteFile file,
      long root,
      long firstNumber,
      long lastNumber,
      BagTopics topics,
      Wanted wanted,
      ViolationCounts violations) {
    this.file = file;
    this.firstNumber = firstNumber;
    this.lastNumber = lastNumber;
    this.topics = topics;
    this.wanted = wanted;
    this.violations = violations;
    messages = new SqliteTable(file, root);
  }

  @Override
  public boolean find() throws IOException {
    found = false;
    while (!ended) {
      try {
        ended = !messages.next();
        if (ended) {
          break;
        }
        SqliteRow row = messages.row();
        row.takeNumber();
        topic = topics.get(row.takeNumber());
        recordedNs = row.takeNumber();
        size = row.takeBlob();
        found = topic != null && wanted.topic(topic);
        if (found) {
          return true;
        }
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    return false;
  }

  @Override
  public BagTopic topic() {
    return topic;
  }

  @Override
  public Payload payload() {
    return messages.row();
  }

  @Override
  public long size() {
    return size;
  }

  @Override
  public String compression() {
    return "none";
  }

  @Override
  public long recordedNs() {
    return recordedNs;
  }

  private long place(long number, double part) {
    double all = Math.max(1.0, (double) lastNumber - firstNumber + 1);
    double before = Math.max(0, (double) number - firstNumber) + part;
    return (long) (Math.min(1.0, before / all) * file.bytes());
  }

  @Override
  public long offset(long done) {
    return place(messages.number(), (double) done / Math.max(1, size));
  }

  @Override
  public long position() {
    return ended ? file.bytes() : place(messages.wanted(), 0);
  }

  @Override
  public void pass(long unused) {
    found = false;
  }

  @Override
  public void damaged(DamagedPacketException damage) {
    violations.add(Violation.DAMAGED_PACKET, place(messages.wanted(), 0));
    found = false;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = found ? messages.number() : messages.wanted();
    state[at + 1] = 0;
  }

  @Override
  public void restore(long[] state, int at) {
    messages.seek(state[at]);
    ended = false;
    found = false;
  }

  @Override
  public void close() {
    // the reader closes the file
  }
}
