package haltere.core.extension;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.ZipFile;

/** Checks that a jar of an extensions folder has something to add. */
final class ExtensionJar {
  private static final String SERVICES = "META-INF/services/";

  private ExtensionJar() {}

  /** The reason why a jar adds nothing; empty if it names a provider. */
  static Optional<String> fault(Path jar) {
    try (ZipFile zip = new ZipFile(jar.toFile())) {
      return zip.stream().anyMatch(entry -> entry.getName().startsWith(SERVICES + "haltere."))
          ? Optional.empty()
          : Optional.of(
              "it adds nothing: a filter needs its provider in "
                  + SERVICES
                  + "haltere.core.chain.FilterProvider, other extensions in the file of theirs");
    } catch (IOException unreadable) {
      return Optional.of("it cannot be read as a jar: " + unreadable.getMessage());
    }
  }
}
