package haltere.core.format.internal.hdf5;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Header of a group or a dataset: a list of messages. */
final class ObjectHeader {
  static final int DATASPACE = 1;
  static final int LINK_INFO = 2;
  static final int DATATYPE = 3;
  static final int LINK = 6;
  static final int EXTERNAL_FILES = 7;
  static final int LAYOUT = 8;
  static final int FILTERS = 11;
  static final int ATTRIBUTE = 12;
  static final int SYMBOL_TABLE = 17;

  private static final int CONTINUATION = 16;
  private static final int MAX_MESSAGES = 4096;
  private static final int MAX_BLOCKS = 256;
  private static final int V1_PREFIX = 16;

  /**
   * A message.
   *
   * @param type of the message
   * @param shared whether its body is a reference
   * @param body its content
   */
  record HeaderMessage(int type, boolean shared, Metadata body) {}

  private final List<HeaderMessage> messages = new ArrayList<>();
  private final Deque<Metadata> blocks = new ArrayDeque<>();
  private final ContainerFile file;
  private int blocksSeen;

  private ObjectHeader(ContainerFile file) {
    this.file = file;
  }

  static ObjectHeader read(ContainerFile file, long position) throws IOException {
    ObjectHeader header = new ObjectHeader(file);
    Metadata prefix = file.upTo(position, 64);
    if (prefix.remaining() >= 4 && prefix.part(4).text(4).equals("OHDR")) {
      header.readNew(position, prefix);
    } else {
      header.readOld(position);
    }
    return header;
  }

  private void readOld(long position) throws IOException {
    Metadata prefix = file.at(position, V1_PREFIX);
    if (prefix.u1() != 1) {
      throw prefix.problem("no header of a group or dataset");
    }
    prefix.skip(1 + 2 + 4);
    blocks.add(file.at(position + V1_PREFIX, prefix.u4()));
    while (!blocks.isEmpty()) {
      Metadata block = blocks.remove();
      while (block.remaining() >= 8) {
        int type = block.u2();
        int size = block.u2();
        int flags = block.u1();
        block.skip(3);
        add(type, flags, block.part(size), 0);
      }
    }
  }

  private void readNew(long position, Metadata prefix) throws IOException {
    int version = prefix.u1();
    if (version != 2) {
      throw prefix.unknown("version " + version + " of an object's header");
    }
    int flags = prefix.u1();
    int sizeBytes = 1 << (flags & 3);
    int before = 6 + ((flags & 0x20) != 0 ? 16 : 0) + ((flags & 0x10) != 0 ? 4 : 0);
    prefix.skip(before - 6);
    long size = prefix.number(sizeBytes);
    blocks.add(file.at(position + before + sizeBytes, size));
    boolean ordered = (flags & 4) != 0;
    while (!blocks.isEmpty()) {
      Metadata block = blocks.remove();
      while (block.remaining() >= (ordered ? 6 : 4)) {
        int type = block.u1();
        int bodySize = block.u2();
        int messageFlags = block.u1();
        block.skip(ordered ? 2 : 0);
        add(type, messageFlags, block.part(bodySize), 8);
      }
    }
  }

  /** Adds a message; continuation blocks have a frame of a number of bytes. */
  private void add(int type, int flags, Metadata body, int frame) throws IOException {
    if (type == CONTINUATION) {
      long position = body.position();
      long length = body.length();
      if (++blocksSeen > MAX_BLOCKS || length < frame) {
        throw body.problem("a header that does not end");
      }
      Metadata block = file.at(position, length);
      if (frame > 0) {
        block.expect("OCHK");
        block = block.part(length - frame);
      }
      blocks.add(block);
      return;
    }
    if (messages.size() == MAX_MESSAGES) {
      throw body.problem("a header of more than " + MAX_MESSAGES + " messages");
    }
    messages.add(new HeaderMessage(type, (flags & 2) != 0, body));
  }

  /** Messages of a kind. Each can be read once. */
  List<HeaderMessage> all(int type) {
    return messages.stream().filter(message -> message.type() == type).toList();
  }

  /** The body of the only message of a kind. */
  Optional<Metadata> one(int type) throws IOException {
    for (HeaderMessage message : messages) {
      if (message.type() == type) {
        return Optional.of(message.shared() ? elsewhere(message) : message.body());
      }
    }
    return Optional.empty();
  }

  boolean has(int type) {
    return messages.stream().anyMatch(message -> message.type() == type);
  }

  /** The content of a shared message, such as a named type. */
  private Metadata elsewhere(HeaderMessage message) throws IOException {
    Metadata body = message.body();
    int version = body.u1();
    int kind = body.u1();
    if (version == 1) {
      body.skip(6);
    } else if (kind != 2 && version == 3) {
      throw body.unknown("a message in the heap of shared messages");
    }
    ObjectHeader other = read(file, body.position());
    for (HeaderMessage there : other.messages) {
      if (there.type() == message.type() && !there.shared()) {
        return there.body();
      }
    }
    throw body.problem("what is shared is not where it should be");
  }
}
