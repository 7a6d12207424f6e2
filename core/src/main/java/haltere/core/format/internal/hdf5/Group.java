package haltere.core.format.internal.hdf5;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.Map;

/** The members of a group by name: positions of their headers. */
final class Group {
  private static final int MAX_MEMBERS = 4096;
  private static final int MAX_DEPTH = 16;
  private static final int MAX_NODES = 4096;
  private static final int MAX_NAME = 4096;

  private final ContainerFile file;
  private final Map<String, Long> members = new LinkedHashMap<>();
  private boolean hidden;
  private int nodes;

  private Group(ContainerFile file) {
    this.file = file;
  }

  /** Whether a header is that of a group. */
  static boolean isGroup(ObjectHeader header) {
    return header.has(ObjectHeader.SYMBOL_TABLE)
        || header.has(ObjectHeader.LINK_INFO)
        || header.has(ObjectHeader.LINK);
  }

  static Group of(ContainerFile file, ObjectHeader header) throws IOException {
    Group group = new Group(file);
    for (ObjectHeader.HeaderMessage message : header.all(ObjectHeader.SYMBOL_TABLE)) {
      long tree = message.body().position();
      group.symbolTable(tree, message.body().position());
    }
    for (ObjectHeader.HeaderMessage message : header.all(ObjectHeader.LINK)) {
      group.link(message.body());
    }
    for (ObjectHeader.HeaderMessage message : header.all(ObjectHeader.LINK_INFO)) {
      Metadata body = message.body();
      body.skip(1);
      if ((body.u1() & 1) != 0) {
        body.skip(8);
      }
      group.hidden = body.position() != ContainerFile.NOWHERE;
    }
    return group;
  }

  Map<String, Long> members() {
    return members;
  }

  /** Whether there are members in an unsupported kind of list. */
  boolean hasHidden() {
    return hidden;
  }

  private void add(String name, long position) {
    if (members.size() < MAX_MEMBERS && position != ContainerFile.NOWHERE) {
      members.putIfAbsent(name, position);
    }
  }

  private void symbolTable(long tree, long heapPlace) throws IOException {
    Metadata heap = file.at(heapPlace, 8 + 2L * file.lengthBytes() + file.offsetBytes());
    heap.expect("HEAP");
    heap.skip(4);
    long size = heap.length();
    heap.length();
    walk(tree, heap.position(), size, MAX_DEPTH);
  }

  private void walk(long tree, long names, long namesSize, int depth) throws IOException {
    Metadata node = file.at(tree, 8 + 2L * file.offsetBytes());
    node.expect("TREE");
    int kind = node.u1();
    int level = node.u1();
    int used = node.u2();
    if (kind != 0 || level >= depth || ++nodes > MAX_NODES) {
      throw node.problem("a list of names that does not end");
    }
    int entry = file.lengthBytes() + file.offsetBytes();
    Metadata entries = file.at(tree + 8 + 2L * file.offsetBytes(), (long) used * entry);
    for (int i = 0; i < used; i++) {
      entries.skip(file.lengthBytes());
      long child = entries.position();
      if (level > 0) {
        walk(child, names, namesSize, level);
      } else {
        symbols(child, names, namesSize);
      }
    }
  }

  private void symbols(long position, long names, long namesSize) throws IOException {
    Metadata head = file.at(position, 8);
    head.expect("SNOD");
    head.skip(2);
    int count = head.u2();
    if (++nodes > MAX_NODES) {
      throw head.problem("a list of names that does not end");
    }
    int size = 2 * file.offsetBytes() + 24;
    Metadata entries = file.at(position + 8, (long) count * size);
    for (int i = 0; i < count; i++) {
      long name = entries.number(file.offsetBytes());
      long header = entries.position();
      entries.skip(24);
      if (name < 0 || name >= namesSize) {
        throw entries.problem("a name outside of the list of names");
      }
      add(name(names + name, namesSize - name), header);
    }
  }

  private String name(long position, long maxLength) throws IOException {
    return file.upTo(position, (int) Math.min(MAX_NAME, maxLength)).textToZero();
  }

  private void link(Metadata body) throws IOException {
    body.skip(1);
    int flags = body.u1();
    int kind = (flags & 8) != 0 ? body.u1() : 0;
    body.skip(((flags & 4) != 0 ? 8 : 0) + ((flags & 16) != 0 ? 1 : 0));
    String name = body.text((int) Math.min(MAX_NAME, body.number(1 << (flags & 3))));
    if (kind == 0) {
      add(name, body.position());
    }
  }
}
