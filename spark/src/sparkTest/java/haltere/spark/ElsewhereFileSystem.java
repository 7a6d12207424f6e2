package haltere.spark;

import java.io.File;
import java.io.IOException;
import java.net.URI;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileStatus;
import org.apache.hadoop.fs.Path;
import org.apache.hadoop.fs.RawLocalFileSystem;

/**
 * A file system with the scheme {@code elsewhere}: no path of it is one of the local disk, where
 * its files are below a folder.
 */
public final class ElsewhereFileSystem extends RawLocalFileSystem {
  static final String SCHEME = "elsewhere";
  static final String ROOT = "fs.elsewhere.root";

  private File root;

  @Override
  public void initialize(URI uri, Configuration settings) throws IOException {
    root = new File(settings.get(ROOT));
    super.initialize(uri, settings);
  }

  @Override
  public String getScheme() {
    return SCHEME;
  }

  @Override
  public URI getUri() {
    return URI.create(SCHEME + ":///");
  }

  @Override
  public File pathToFile(Path path) {
    checkPath(path);
    return new File(root, makeQualified(path).toUri().getPath());
  }

  @Override
  public FileStatus getFileStatus(Path path) throws IOException {
    FileStatus local = super.getFileStatus(path);
    return new FileStatus(
        local.getLen(),
        local.isDirectory(),
        local.getReplication(),
        local.getBlockSize(),
        local.getModificationTime(),
        makeQualified(path));
  }
}
