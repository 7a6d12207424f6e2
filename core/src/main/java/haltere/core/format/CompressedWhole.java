package haltere.core.format;

import java.util.Map;
import java.util.Optional;

/**
 * Detects files that are compressed as a whole, which no format reads because they do not allow
 * seeking.
 */
final class CompressedWhole {
  private static final Map<String, String> PROGRAMS =
      Map.of(
          "\u0028\u00b5\u002f\u00fd", "zstd -d",
          "\u001f\u008b", "gunzip",
          "BZh", "bunzip2",
          "\u00fd7zXZ", "unxz",
          "\u0004\"M\u0018", "lz4 -d",
          "7z\u00bc\u00af", "7z x",
          "Rar!", "unrar x",
          "PK\u0003\u0004", "unzip");

  private CompressedWhole() {}

  /**
   * The program that decompresses a file.
   *
   * @param head its start
   * @return a command without the file's name, or empty if no known compression is detected
   */
  static Optional<String> program(FileHead head) {
    return PROGRAMS.entrySet().stream()
        .filter(entry -> head.startsWith(entry.getKey()))
        .map(Map.Entry::getValue)
        .findFirst();
  }
}
