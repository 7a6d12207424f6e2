package haltere.core.pipeline.internal;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.sink.TableMetadata;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;

/**
 * What results were made with: program, settings, and the recording with its SHA-256. Entries:
 * {@code haltere.program}, {@code haltere.recording} (a name without folders), {@code
 * haltere.recordingSha256} (of files and folders, not of cameras and streams), and {@code
 * haltere.chain} or other settings as JSON. All tables of a job share one, so the recording is read
 * once for its checksum, and only by formats that ask.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class Provenance implements TableMetadata {
  private final String program;
  private final Optional<Path> recording;
  private final Map<String, Supplier<String>> settings = new LinkedHashMap<>();
  private String sha256;

  /**
   * Results of a program.
   *
   * @param program name and version
   * @param recording what was read, if it is a file, a folder or a camera with a name
   */
  public Provenance(String program, Optional<Path> recording) {
    this.program = Objects.requireNonNull(program, "program");
    this.recording = Objects.requireNonNull(recording, "recording");
  }

  /**
   * Adds the chain, with the settings that it has at the end.
   *
   * @param chain the chain
   * @return this
   */
  public Provenance chain(FilterChain chain) {
    return with("haltere.chain", () -> ChainFile.write(chain));
  }

  /**
   * Adds an entry.
   *
   * @param name its name
   * @param value computed when a table is finished
   * @return this
   */
  public Provenance with(String name, Supplier<String> value) {
    settings.put(name, value);
    return this;
  }

  /**
   * The SHA-256 of the recording.
   *
   * @return 64 digits; empty if the recording is no file or folder
   * @throws IOException if it cannot be read
   */
  public Optional<String> recordingSha256() throws IOException {
    if (sha256 == null && recording.isPresent()) {
      Path path = recording.get();
      sha256 = Files.isRegularFile(path) || Files.isDirectory(path) ? Checksums.of(path) : "";
    }
    return Optional.ofNullable(sha256).filter(digits -> !digits.isEmpty());
  }

  @Override
  public Map<String, String> entries() throws IOException {
    Map<String, String> entries = new LinkedHashMap<>();
    entries.put("haltere.program", program);
    recording.ifPresent(path -> entries.put("haltere.recording", "" + path.getFileName()));
    recordingSha256().ifPresent(digits -> entries.put("haltere.recordingSha256", digits));
    settings.forEach((name, value) -> entries.put(name, value.get()));
    return entries;
  }
}
