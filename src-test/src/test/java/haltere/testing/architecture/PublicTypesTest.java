package haltere.testing.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rules of docs/compatibility.md for public types. */
class PublicTypesTest {
  private static final Pattern PUBLIC_TYPE = Pattern.compile("(?m)^public ");
  private static final Pattern SINCE = Pattern.compile("\\* @since \\d+\\.\\d+\\R");

  @ParameterizedTest
  @ValueSource(strings = {"core", "filters"})
  void everyPublicTypeOrItsPackageHasASinceTag(String module) throws IOException {
    Path sources = Path.of("..", module, "src", "main", "java");
    List<Path> types;
    try (Stream<Path> files = Files.walk(sources)) {
      types =
          files
              .filter(file -> file.toString().endsWith(".java"))
              .filter(file -> !file.endsWith("package-info.java"))
              .filter(file -> !file.toString().contains("internal"))
              .toList();
    }
    assertTrue(types.size() > 50, types::toString);
    assertEquals(List.of(), types.stream().filter(PublicTypesTest::isPublicWithoutSince).toList());
  }

  private static boolean isPublicWithoutSince(Path type) {
    String text = read(type);
    Matcher declared = PUBLIC_TYPE.matcher(text);
    return declared.find()
        && !SINCE.matcher(text.substring(0, declared.start())).find()
        && !SINCE.matcher(read(type.resolveSibling("package-info.java"))).find();
  }

  private static String read(Path file) {
    try {
      return Files.exists(file) ? Files.readString(file) : "";
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
