package haltere.core.extension;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExtensionJarTest {
  @TempDir Path folder;

  @Test
  void jarWithoutAProviderIsReported() throws IOException {
    Path jar = jar("forgotten.jar", "com/example/MyFilter.class");
    assertTrue(
        ExtensionJar.fault(jar)
            .orElseThrow()
            .contains("META-INF/services/haltere.core.chain.FilterProvider"));
    Extensions.open(folder);
    assertTrue(
        Extensions.problems().stream().anyMatch(line -> line.startsWith("forgotten.jar: it adds")));
  }

  @Test
  void fileThatIsNoJarIsReported() throws IOException {
    Path jar = Files.writeString(folder.resolve("text.jar"), "no jar");
    assertTrue(ExtensionJar.fault(jar).orElseThrow().startsWith("it cannot be read as a jar: "));
  }

  @Test
  void jarWithAProviderIsAccepted() throws IOException {
    Path jar = jar("good.jar", "META-INF/services/haltere.core.format.RecordingFormat");
    assertEquals(Optional.empty(), ExtensionJar.fault(jar));
  }

  private Path jar(String name, String entry) throws IOException {
    Path jar = folder.resolve(name);
    try (ZipOutputStream zip = new ZipOutputStream(Files.newOutputStream(jar))) {
      zip.putNextEntry(new ZipEntry(entry));
    }
    return jar;
  }
}
