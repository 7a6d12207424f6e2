package haltere.testing.embedding;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.Filters;
import haltere.core.extension.Extensions;
import haltere.core.format.Recordings;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The library in a class loader of a host, as image editors, workbenches and notebooks load it. */
class HostClassLoaderTest {
  private static final String SERVICE = "META-INF/services/haltere.core.chain.FilterProvider";

  @TempDir Path folder;

  private final ClassLoader before = Thread.currentThread().getContextClassLoader();
  private URLClassLoader host;

  @BeforeEach
  void loadTheLibraryApart() throws IOException {
    List<URL> urls = new ArrayList<>();
    for (String entry : System.getProperty("java.class.path").split(File.pathSeparator)) {
      urls.add(Path.of(entry).toUri().toURL());
    }
    host = new URLClassLoader(urls.toArray(URL[]::new), ClassLoader.getPlatformClassLoader());
  }

  @AfterEach
  void close() throws IOException {
    Thread.currentThread().setContextClassLoader(before);
    host.close();
  }

  private Object call(Class<?> type, String method, Class<?>[] types, Object... values)
      throws ReflectiveOperationException {
    return host.loadClass(type.getName()).getMethod(method, types).invoke(null, values);
  }

  private Map<?, ?> filters() throws ReflectiveOperationException {
    return (Map<?, ?>) call(Filters.class, "all", new Class<?>[0]);
  }

  private List<?> problems() throws ReflectiveOperationException {
    return (List<?>) call(Extensions.class, "problems", new Class<?>[0]);
  }

  @Test
  void formatsAndFiltersAreFoundWhateverTheContextClassLoader()
      throws ReflectiveOperationException {
    assertNotSame(Filters.class, host.loadClass(Filters.class.getName()));
    ClassLoader[] contexts = {null, ClassLoader.getPlatformClassLoader(), before, host};
    for (ClassLoader context : contexts) {
      Thread.currentThread().setContextClassLoader(context);
      assertEquals(
          Recordings.formats().keySet(),
          ((Map<?, ?>) call(Recordings.class, "formats", new Class<?>[0])).keySet());
      assertEquals(Filters.all().keySet(), filters().keySet());
      assertEquals(List.of(), problems());
    }
  }

  @Test
  void extensionJarProvidesItsFilterAndBrokenJarsAreReportedAndSkipped() throws Exception {
    Path extensions = Files.createDirectory(folder.resolve("extensions"));
    jar(extensions.resolve("good.jar"), "Good", provider("Good", "good", SETTINGS_WITH_UNIT));
    jar(extensions.resolve("unitless.jar"), "Bare", provider("Bare", "bare", SETTINGS_WITHOUT));
    jar(extensions.resolve("missing.jar"), "Missing", List.of());
    jar(extensions.resolve("again.jar"), "Again", provider("Again", "good", SETTINGS_WITH_UNIT));
    Files.writeString(extensions.resolve("readme.txt"), "not a jar");

    Collection<?> jars =
        (Collection<?>) call(Extensions.class, "open", new Class<?>[] {Path.class}, extensions);
    assertEquals(4, jars.size());
    Map<?, ?> found = filters();
    assertTrue(found.containsKey("good"), found.keySet().toString());
    assertFalse(found.containsKey("bare"), found.keySet().toString());
    assertTrue(found.keySet().containsAll(Filters.all().keySet()));
    String said = String.join("\n", problems().stream().map(Object::toString).toList());
    assertEquals(3, problems().size(), said);
    assertTrue(said.contains("missing.jar") && said.contains("Missing"), said);
    assertTrue(said.contains("Bare is left out") && said.contains("@Unit"), said);
    assertTrue(said.contains("another filter is named good"), said);
  }

  private static final String SETTINGS_WITH_UNIT =
      "@haltere.core.settings.Range(min = 0, max = 1) @haltere.core.settings.Unit(\"Hz\")"
          + " @haltere.core.settings.Help(\"A rate.\") double rateHz";
  private static final String SETTINGS_WITHOUT =
      "@haltere.core.settings.Help(\"A rate.\") double rateHz";

  /** Sources of a provider and its settings. */
  private static List<String> provider(String type, String name, String component) {
    String settings =
        "public record %1$sSettings(%2$s) {\n"
            + "  public static %1$sSettings defaults() { return new %1$sSettings(0.5); }\n"
            + "}\n";
    String provider =
        """
        public final class %1$s implements haltere.core.chain.FilterProvider<%1$sSettings> {
          public String name() { return "%2$s"; }
          public String description() { return "Lets everything through."; }
          public Class<%1$sSettings> settingsType() { return %1$sSettings.class; }
          public haltere.core.chain.ConfigurableFilter<%1$sSettings> create(
              haltere.core.event.SensorGeometry geometry, %1$sSettings settings) {
            throw new UnsupportedOperationException();
          }
        }
        """;
    return List.of(settings.formatted(type, component), provider.formatted(type, name));
  }

  /** A jar with compiled sources and a service entry. */
  private void jar(Path file, String service, List<String> sources) throws Exception {
    Path classes = Files.createDirectories(folder.resolve("classes-" + service));
    if (!sources.isEmpty()) {
      Path settings = folder.resolve(service + "Settings.java");
      Path provider = folder.resolve(service + ".java");
      Files.writeString(settings, sources.get(0));
      Files.writeString(provider, sources.get(1));
      int status =
          ToolProvider.getSystemJavaCompiler()
              .run(
                  null,
                  OutputStream.nullOutputStream(),
                  null,
                  "-cp",
                  System.getProperty("java.class.path"),
                  "-d",
                  classes.toString(),
                  settings.toString(),
                  provider.toString());
      assertEquals(0, status, "the sources of the test do not compile");
    }
    try (JarOutputStream jar = new JarOutputStream(Files.newOutputStream(file));
        Stream<Path> all = Files.list(classes)) {
      jar.putNextEntry(new JarEntry(SERVICE));
      jar.write(service.getBytes(StandardCharsets.UTF_8));
      for (Path compiled : (Iterable<Path>) all::iterator) {
        jar.putNextEntry(new JarEntry(compiled.getFileName().toString()));
        jar.write(Files.readAllBytes(compiled));
      }
    }
  }
}
