package haltere.core.format.internal.hdf5;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The structure of written files except the trees of chunks: a superblock of version 0 and groups
 * as symbol tables, which every HDF5 reader supports. It has a fixed size, so that it is at the
 * start of the file although it is written last.
 */
final class Hdf5Structure {
  /** Its size at the start of a file in bytes. */
  static final int BYTES = 4096;

  private static final int SYMBOLS_PER_NODE = 8;
  private static final int GROUP_NODE_BYTES = 544;
  private static final int SYMBOL_BYTES = 40;
  private static final int ROOT_ENTRY = 56;

  private final Hdf5Bytes bytes = new Hdf5Bytes(BYTES);

  private Hdf5Structure() {}

  /**
   * Lays out a file.
   *
   * @param end bytes of the file
   * @param attributes integers of the root group
   * @param timeOffsetUs the dataset of one number
   * @param events columns of the group of events and the roots of their trees
   * @param index as events: datasets of the root group, may be empty
   * @return the first {@link #BYTES} of the file
   */
  static ByteBuffer of(
      long end,
      Map<String, Long> attributes,
      long timeOffsetUs,
      Map<ChunkedColumn, Long> events,
      Map<ChunkedColumn, Long> index) {
    Hdf5Structure structure = new Hdf5Structure();
    structure.superblock(end);
    List<GroupMember> columns = new ArrayList<>();
    events.forEach((column, tree) -> columns.add(structure.dataset(column, tree)));
    MemberList eventGroup = structure.group(columns);
    List<GroupMember> top = new ArrayList<>();
    top.add(new GroupMember("events", structure.header(eventGroup, Map.of()), eventGroup));
    index.forEach((column, tree) -> top.add(structure.dataset(column, tree)));
    top.add(structure.number(EventTable.TIME_OFFSET, timeOffsetUs));
    return structure.finish(top, attributes);
  }

  /**
   * Lays out a file of one table.
   *
   * @param end bytes of the file
   * @param table its rows
   * @param tree root of its tree of chunks
   * @return the first {@link #BYTES} of the file
   */
  static ByteBuffer of(long end, ChunkedColumn table, long tree) {
    Hdf5Structure structure = new Hdf5Structure();
    structure.superblock(end);
    return structure.finish(List.of(structure.dataset(table, tree)), Map.of());
  }

  private void superblock(long end) {
    bytes.u1(0x89).text("HDF\r\n\u001a\n").u4(0).u1(0).u1(8).u1(8).u1(0);
    bytes.u2(SYMBOLS_PER_NODE / 2).u2(16).u4(0).u8(0).u8(-1).u8(end).u8(-1);
    bytes.skip(SYMBOL_BYTES);
  }

  private ByteBuffer finish(List<GroupMember> top, Map<String, Long> attributes) {
    MemberList root = group(top);
    long rootHeader = header(root, attributes);
    ByteBuffer whole = bytes.whole();
    whole.position(ROOT_ENTRY);
    entry(whole, 0, rootHeader, root);
    return whole.clear();
  }

  /** Position of a group's list of members. */
  private record MemberList(long tree, long heap) {}

  /** A member of a group; its own list of members is null for a dataset. */
  private record GroupMember(String name, long header, MemberList group) {}

  private static void entry(ByteBuffer bytes, long name, long header, MemberList group) {
    bytes.putLong(name).putLong(header).putInt(group == null ? 0 : 1).putInt(0);
    bytes.putLong(group == null ? 0 : group.tree()).putLong(group == null ? 0 : group.heap());
  }

  /** Writes names, symbols and tree of a group. Members are in the order of their names. */
  private MemberList group(List<GroupMember> members) {
    long heap = bytes.position();
    int namesBytes = 8;
    for (GroupMember member : members) {
      namesBytes += (member.name().length() + 8) / 8 * 8;
    }
    bytes.text("HEAP").u4(0).u8(namesBytes).u8(1).u8(heap + 32).u8(0);
    List<Long> names = new ArrayList<>();
    for (GroupMember member : members) {
      names.add(bytes.position() - heap - 32);
      bytes.text(member.name()).pad(1);
    }
    long symbols = bytes.position();
    bytes.text("SNOD").u1(1).u1(0).u2(members.size());
    ByteBuffer entries = ByteBuffer.allocate(SYMBOL_BYTES).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < members.size(); i++) {
      GroupMember member = members.get(i);
      entries.clear();
      entry(entries, names.get(i), member.header(), member.group());
      entries.flip();
      while (entries.hasRemaining()) {
        bytes.u8(entries.getLong());
      }
    }
    bytes.skip((SYMBOLS_PER_NODE - members.size()) * SYMBOL_BYTES);
    long tree = bytes.position();
    bytes.text("TREE").u1(0).u1(0).u2(1).u8(-1).u8(-1);
    bytes.u8(0).u8(symbols).u8(names.get(names.size() - 1));
    bytes.skip((int) (tree + GROUP_NODE_BYTES - bytes.position()));
    return new MemberList(tree, heap);
  }

  private long header(MemberList group, Map<String, Long> attributes) {
    int start = startHeader();
    int message = startMessage(ObjectHeader.SYMBOL_TABLE);
    bytes.u8(group.tree()).u8(group.heap());
    endMessage(message);
    attributes.forEach(this::attribute);
    endHeader(start, 1 + attributes.size());
    return start;
  }

  private void attribute(String name, long value) {
    int message = startMessage(ObjectHeader.ATTRIBUTE);
    bytes.u1(1).u1(0).u2(name.length() + 1).u2(12).u2(8);
    bytes.text(name).pad(1);
    type(ElementType.whole(8, true));
    bytes.pad(0).u1(1).skip(7).u8(value);
    endMessage(message);
  }

  private void type(ElementType type) {
    int size = type.bytes();
    switch (type.kind()) {
      case 'c' -> {
        bytes.u1(0x16).u1(type.members().size()).u2(0).u4(size);
        for (ElementType.Member member : type.members()) {
          bytes.padded(member.name()).u4(member.offset()).skip(28);
          type(member.type());
        }
      }
      case 'f' -> {
        int mantissa = size == 8 ? 52 : 23;
        int exponent = size == 8 ? 11 : 8;
        bytes.u1(0x11).u1(0x20).u1(8 * size - 1).u1(0).u4(size).u2(0).u2(8 * size);
        bytes.u1(mantissa).u1(exponent).u1(0).u1(mantissa).u4((1 << exponent - 1) - 1);
      }
      default -> {
        bytes.u1(0x10).u1(type.kind() == 'i' ? 8 : 0).u2(0).u4(size).u2(0).u2(8 * size);
      }
    }
  }

  private GroupMember number(String name, long value) {
    long position = bytes.position();
    bytes.u8(value);
    int start = startHeader();
    int message = startMessage(ObjectHeader.DATASPACE);
    bytes.u1(1).skip(7);
    endMessage(message);
    typeAndFill(ElementType.whole(8, true));
    message = startMessage(ObjectHeader.LAYOUT);
    bytes.u1(3).u1(1).u8(position).u8(8);
    endMessage(message);
    endHeader(start, 4);
    return new GroupMember(name, start, null);
  }

  private void typeAndFill(ElementType type) {
    int message = startMessage(ObjectHeader.DATATYPE);
    type(type);
    endMessage(message);
    message = startMessage(5);
    bytes.u1(2).u1(3).u1(2).u1(1).u4(0);
    endMessage(message);
  }

  private GroupMember dataset(ChunkedColumn column, long tree) {
    int start = startHeader();
    int message = startMessage(ObjectHeader.DATASPACE);
    bytes.u1(1).u1(1).u1(1).skip(5).u8(column.rows()).u8(-1);
    endMessage(message);
    typeAndFill(column.type());
    message = startMessage(ObjectHeader.LAYOUT);
    bytes.u1(3).u1(2).u1(2).u8(tree).u4(column.chunkRows()).u4(column.type().bytes());
    endMessage(message);
    if (column.level() > 0) {
      boolean shuffled = column.type().bytes() > 1;
      message = startMessage(ObjectHeader.FILTERS);
      bytes.u1(1).u1(shuffled ? 2 : 1).skip(6);
      if (shuffled) {
        bytes.u2(FilterStep.SHUFFLE).u2(0).u2(1).u2(1).u4(column.type().bytes()).u4(0);
      }
      bytes.u2(FilterStep.DEFLATE).u2(0).u2(1).u2(1).u4(column.level()).u4(0);
      endMessage(message);
    }
    endHeader(start, column.level() > 0 ? 5 : 4);
    return new GroupMember(column.name(), start, null);
  }

  private int startHeader() {
    bytes.pad(0);
    int start = bytes.position();
    bytes.skip(16);
    return start;
  }

  private void endHeader(int start, int messages) {
    bytes.u1At(start, 1);
    bytes.u2At(start + 2, messages);
    bytes.u4At(start + 4, 1);
    bytes.u4At(start + 8, bytes.position() - start - 16L);
  }

  private int startMessage(int type) {
    int start = bytes.position();
    bytes.u2(type).skip(6);
    return start;
  }

  private void endMessage(int start) {
    bytes.pad(0);
    bytes.u2At(start + 2, bytes.position() - start - 8);
  }
}
