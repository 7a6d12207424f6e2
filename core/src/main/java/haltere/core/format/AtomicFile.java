package haltere.core.format;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.Objects;
import java.util.UUID;

/**
 * An output file that is replaced atomically: it is written to a hidden temporary file beside its
 * target, which {@link #commit()} renames. Closing it earlier deletes the temporary file.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public final class AtomicFile implements Closeable, WritableByteChannel {
  /** Ending of a file that is being written. */
  public static final String PART = ".part";

  private final Path requested;
  private final Path target;
  private final Path temporary;
  private final boolean overwrite;
  private final boolean staged;
  private final FileChannel channel;
  private final OutputStream stream;
  private boolean committed;

  private AtomicFile(
      Path requested,
      Path target,
      Path temporary,
      boolean overwrite,
      boolean staged,
      FileChannel channel,
      OutputStream stream) {
    this.requested = requested;
    this.target = target;
    this.temporary = temporary;
    this.overwrite = overwrite;
    this.staged = staged;
    this.channel = channel;
    this.stream = stream;
  }

  /**
   * Writes to a stream, without atomicity.
   *
   * @param name name of the stream for messages
   * @param stream flushed at the end, never closed
   * @return a file without a {@link #channel()}
   */
  public static AtomicFile on(Path name, OutputStream stream) {
    return new AtomicFile(
        name, name, name, true, false, null, Objects.requireNonNull(stream, "stream"));
  }

  /**
   * Starts a file with a fixed temporary name, the target's followed by {@code .part}, which a
   * repeated attempt overwrites if this process is killed. {@link #commit} keeps that name until
   * {@link #place}, so that another thread can wait for the disk.
   *
   * @param target path of the file, in a folder that only one process writes to
   * @return an empty file
   * @throws IOException if the file cannot be created
   */
  public static AtomicFile staged(Path target) throws IOException {
    Path temporary = part(target);
    FileChannel channel =
        FileChannel.open(
            temporary,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
    return new AtomicFile(target, target, temporary, true, true, channel, null);
  }

  private static Path part(Path target) {
    return target.resolveSibling(target.getFileName() + PART);
  }

  /**
   * Forces a committed {@link #staged} file to the disk and renames it. An existing file is
   * replaced.
   *
   * @param target as passed to {@link #staged}
   * @throws IOException if that fails; the temporary file is deleted
   */
  public static void place(Path target) throws IOException {
    try {
      try (FileChannel file = FileChannel.open(part(target), StandardOpenOption.WRITE)) {
        file.force(true);
      }
      move(part(target), target);
    } catch (IOException e) {
      Files.deleteIfExists(part(target));
      throw RecordingProblem.writing(target, e);
    }
  }

  /**
   * Starts a file.
   *
   * @param target path of the file; a symbolic link is followed
   * @param overwrite whether an existing file may be replaced
   * @return an empty file
   * @throws RecordingProblem if the target exists and may not be replaced, or its folder cannot be
   *     written to
   * @throws IOException if the file cannot be created for another reason
   */
  public static AtomicFile create(Path target, boolean overwrite) throws IOException {
    if (Files.isDirectory(target)) {
      throw new RecordingProblem(target, "this is a folder already; choose another name");
    }
    refuseExisting(target, overwrite);
    RecordingFile.checkRegular(target);
    Path real = Files.exists(target) ? target.toRealPath() : target.toAbsolutePath();
    Path folder = real.getParent();
    Path name = real.getFileName();
    if (folder == null || name == null) {
      throw new RecordingProblem(target, "this does not name a file");
    }
    if (!Files.isDirectory(folder)) {
      throw new RecordingProblem(target, "its folder does not exist; make it first");
    }
    Path temporary = folder.resolve("." + name + "." + UUID.randomUUID() + PART);
    try {
      FileChannel channel =
          FileChannel.open(temporary, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      return new AtomicFile(target, real, temporary, overwrite, false, channel, null);
    } catch (AccessDeniedException e) {
      throw RecordingProblem.of(target, "no permission to write in its folder", e);
    } catch (IOException e) {
      throw RecordingProblem.writing(target, e);
    }
  }

  /**
   * Writes a file atomically.
   *
   * @param target path of the file; a symbolic link is followed
   * @param bytes its content
   * @param overwrite whether an existing file may be replaced
   * @throws IOException as {@link #create}, or if it cannot be written
   */
  public static void write(Path target, byte[] bytes, boolean overwrite) throws IOException {
    try (AtomicFile file = create(target, overwrite)) {
      file.stream().write(bytes);
      file.commit();
    }
  }

  /**
   * Writes a text file, in UTF-8, atomically.
   *
   * @param target path of the file; a symbolic link is followed
   * @param text its content
   * @param overwrite whether an existing file may be replaced
   * @throws IOException as {@link #create}, or if it cannot be written
   */
  public static void write(Path target, String text, boolean overwrite) throws IOException {
    write(target, text.getBytes(StandardCharsets.UTF_8), overwrite);
  }

  private static void refuseExisting(Path target, boolean overwrite) throws RecordingProblem {
    if (!overwrite && Files.exists(target, LinkOption.NOFOLLOW_LINKS)) {
      throw new RecordingProblem(target, "it exists already; give --overwrite or another name");
    }
  }

  /**
   * The target.
   *
   * @return the path as given
   */
  public Path path() {
    return requested;
  }

  /**
   * The channel to write to.
   *
   * @return owned by this file, closed with it
   */
  public FileChannel channel() {
    return channel;
  }

  /**
   * A stream that writes to the channel, without a buffer.
   *
   * @return owned by this file
   */
  public OutputStream stream() {
    return Channels.newOutputStream(this);
  }

  @Override
  public int write(ByteBuffer source) throws IOException {
    int count = source.remaining();
    try {
      if (stream != null) {
        Channels.newChannel(stream).write(source);
      }
      while (source.hasRemaining()) {
        channel.write(source);
      }
    } catch (IOException e) {
      throw RecordingProblem.writing(requested, e);
    }
    return count;
  }

  @Override
  public boolean isOpen() {
    return stream != null || channel.isOpen();
  }

  /**
   * Rejects data for a complete file, which would be lost.
   *
   * @throws IllegalStateException after {@link #commit()}
   */
  public void requireUncommitted() {
    if (committed) {
      throw new IllegalStateException(requested + " is complete; nothing can be added to it");
    }
  }

  /**
   * Renames the file to its target, or prepares it for {@link #place} if it is {@link #staged}.
   *
   * @throws IOException if that fails; the target is then unchanged
   */
  public void commit() throws IOException {
    requireUncommitted();
    try {
      if (stream != null) {
        stream.flush();
      } else {
        channel.close();
        if (!staged) {
          refuseExisting(requested, overwrite);
          move(temporary, target);
        }
      }
    } catch (IOException e) {
      throw RecordingProblem.writing(requested, e);
    }
    committed = true;
  }

  private static void move(Path temporary, Path target) throws IOException {
    try {
      Files.move(
          temporary, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(temporary, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /**
   * Closes the file; without a {@link #commit()} before, the temporary file is deleted.
   *
   * @throws IOException if it cannot be removed
   */
  @Override
  public void close() throws IOException {
    if (stream != null) {
      return;
    }
    channel.close();
    if (!committed) {
      Files.deleteIfExists(temporary);
    }
  }
}
