package haltere.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.Modifier;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Compares a module's service files with its classes. */
public final class ServiceFiles {
  private ServiceFiles() {}

  /**
   * The classes of a module that implement a service.
   *
   * @param service the interface
   * @param oneClass any class of the module, which must lie in a folder of class files
   * @return binary names of all concrete classes, in order
   */
  public static Set<String> implementations(Class<?> service, Class<?> oneClass) {
    Path classes = folderOf(oneClass);
    try (Stream<Path> files = Files.walk(classes)) {
      return files
          .map(file -> classes.relativize(file).toString().replace('\\', '/'))
          .filter(name -> name.endsWith(".class") && !name.endsWith("-info.class"))
          .map(name -> name.substring(0, name.length() - ".class".length()).replace('/', '.'))
          .filter(name -> implementsService(name, service))
          .collect(Collectors.toCollection(TreeSet::new));
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
  }

  private static Path folderOf(Class<?> type) {
    try {
      Path folder = Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
      if (!Files.isDirectory(folder)) {
        throw new IllegalArgumentException(type + " does not lie in a folder but in " + folder);
      }
      return folder;
    } catch (URISyntaxException impossible) {
      throw new IllegalStateException(impossible);
    }
  }

  private static boolean implementsService(String name, Class<?> service) {
    try {
      Class<?> type = Class.forName(name, false, service.getClassLoader());
      return service.isAssignableFrom(type)
          && !type.isInterface()
          && !Modifier.isAbstract(type.getModifiers());
    } catch (ClassNotFoundException missing) {
      throw new IllegalStateException(missing);
    }
  }

  /**
   * The names in all files of a service on the class path.
   *
   * @param service the interface
   * @return names without comments and empty lines, in order
   */
  public static Set<String> registered(Class<?> service) {
    Set<String> names = new TreeSet<>();
    try {
      List<URL> files =
          service.getClassLoader().resources("META-INF/services/" + service.getName()).toList();
      for (URL file : files) {
        try (InputStream in = file.openStream()) {
          new String(in.readAllBytes(), StandardCharsets.UTF_8)
              .lines()
              .map(line -> line.replaceFirst("#.*", "").trim())
              .filter(line -> !line.isEmpty())
              .forEach(names::add);
        }
      }
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
    return names;
  }
}
