package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Iterates over the rows of an SQLite table in ascending order of their numbers: a tree of pages
 * with the rows in its leaves. Every leaf is searched from the root, so that a position is only a
 * number, and a cyclic tree ends.
 *
 * <p>Thread rule: one thread.
 */
final class SqliteTable {
  private static final int LEAF = 13;
  private static final int INNER = 5;
  private static final int LEAF_HEAD = 8;
  private static final int INNER_HEAD = 12;
  private static final int MAX_DEPTH = 24;
  private static final int FIRST_PAGE_HEADER = 100;

  private final SqliteFile file;
  private final long root;
  private final ByteBuffer leaf;
  private final SqliteRow row;

  private boolean inLeaf;
  private boolean ended;
  private int head;
  private int cell;
  private int cells;
  private long leafPage;
  private long lastOfLeaf;
  private long wanted = Long.MIN_VALUE;
  private long number;
  private long rowBytes;
  private int at;

  SqliteTable(SqliteFile file, long root) {
    this.file = file;
    this.root = root;
    leaf = file.page();
    row = new SqliteRow(file);
  }

  /** Continues at the first row with at least this number. */
  void seek(long rowNumber) {
    wanted = rowNumber;
    inLeaf = false;
    ended = false;
  }

  /** Minimum number of the next row. */
  long wanted() {
    return wanted;
  }

  /** Number of the current row. */
  long number() {
    return number;
  }

  /** Page on which the current row begins. */
  long page() {
    return leafPage;
  }

  SqliteRow row() {
    return row;
  }

  /**
   * Finds the next row.
   *
   * @return false at the end
   * @throws DamagedPacketException if a page or row is damaged; the next call continues after it
   */
  boolean next() throws IOException, DamagedPacketException {
    while (!ended) {
      if (!inLeaf) {
        findLeaf();
      }
      while (cell < cells) {
        readCell(cell++);
        if (number >= wanted) {
          pass(number);
          row.open(leaf, at, rowBytes);
          return true;
        }
      }
      pass(lastOfLeaf);
      inLeaf = false;
    }
    return false;
  }

  /** Marks the rows up to a number as visited. */
  private void pass(long done) {
    ended = done == Long.MAX_VALUE;
    wanted = Math.max(wanted, ended ? done : done + 1);
  }

  private void readCell(int index) throws DamagedPacketException {
    at = unsignedShort(head + LEAF_HEAD + 2 * index);
    rowBytes = SqliteVarint.take(this::takeByte);
    number = SqliteVarint.take(this::takeByte);
  }

  /** Descends from the root to the leaf of the requested row. */
  private void findLeaf() throws IOException, DamagedPacketException {
    long page = root;
    lastOfLeaf = Long.MAX_VALUE;
    cell = 0;
    cells = 0;
    inLeaf = true;
    for (int depth = 0; depth < MAX_DEPTH; depth++) {
      leafPage = page;
      file.read(leaf, page);
      head = page == 1 ? FIRST_PAGE_HEADER : 0;
      int kind = leaf.get(head);
      int count = unsignedShort(head + 3);
      if (kind == LEAF) {
        cells = count;
        return;
      }
      if (kind != INNER) {
        throw new DamagedPacketException("a page of no table");
      }
      page = child(count);
    }
    throw new DamagedPacketException("pages that lead in a circle");
  }

  /** The child page of an inner page with the requested row. */
  private long child(int count) throws DamagedPacketException {
    for (int i = 0; i < count; i++) {
      at = unsignedShort(head + INNER_HEAD + 2 * i);
      long page = unsignedInt(at);
      at += 4;
      long last = SqliteVarint.take(this::takeByte);
      if (last >= wanted) {
        lastOfLeaf = Math.min(lastOfLeaf, last);
        return page;
      }
    }
    return unsignedInt(head + 8);
  }

  private int unsignedShort(int index) throws DamagedPacketException {
    check(index, 2);
    return leaf.getShort(index) & 0xffff;
  }

  private long unsignedInt(int index) throws DamagedPacketException {
    check(index, 4);
    return leaf.getInt(index) & 0xffff_ffffL;
  }

  private void check(int index, int bytes) throws DamagedPacketException {
    if (index + bytes > file.usableBytes()) {
      throw new DamagedPacketException("a cell outside of its page");
    }
  }

  private byte takeByte() throws DamagedPacketException {
    check(at, 1);
    return leaf.get(at++);
  }
}
