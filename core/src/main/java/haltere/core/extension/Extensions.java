package haltere.core.extension;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;

/**
 * Finds the providers of a service: those that the library's own class loader knows, those of class
 * loaders that a host has registered, and those of the thread's context class loader. So the
 * library finds all of its formats and filters wherever a host (an application server, an image
 * editor, a notebook) has loaded it. A provider that cannot be loaded is left out and {@link
 * #problems() named}; the others work.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Extensions {
  private static final ClassLoader OWN = Extensions.class.getClassLoader();
  private static final Map<Class<?>, List<?>> OWN_PROVIDERS = new ConcurrentHashMap<>();
  private static final CopyOnWriteArrayList<Registered> REGISTERED = new CopyOnWriteArrayList<>();
  private static final Set<Path> OPENED = ConcurrentHashMap.newKeySet();
  private static final CopyOnWriteArrayList<String> PROBLEMS = new CopyOnWriteArrayList<>();

  private Extensions() {}

  /** A class loader of a host or of a jar. */
  private record Registered(ClassLoader loader, String name, Map<Class<?>, List<?>> providers) {}

  /**
   * The providers of a service.
   *
   * @param service an interface of the library
   * @param <T> the same
   * @return each class once, the library's own first; those of the context class loader last
   */
  public static <T> List<T> find(Class<T> service) {
    Map<Class<?>, T> found = new LinkedHashMap<>();
    add(found, cached(OWN_PROVIDERS, service, OWN, ""));
    for (Registered registered : REGISTERED) {
      add(
          found,
          cached(registered.providers(), service, registered.loader(), registered.name() + ": "));
    }
    ClassLoader context = Thread.currentThread().getContextClassLoader();
    if (context != null && context != OWN && sees(context, service)) {
      add(found, load(service, context, ""));
    }
    return List.copyOf(found.values());
  }

  private static <T> void add(Map<Class<?>, T> found, List<T> more) {
    more.forEach(provider -> found.putIfAbsent(provider.getClass(), provider));
  }

  @SuppressWarnings("unchecked")
  private static <T> List<T> cached(
      Map<Class<?>, List<?>> cache, Class<T> service, ClassLoader loader, String name) {
    return (List<T>) cache.computeIfAbsent(service, key -> load(service, loader, name));
  }

  /** Whether a loader has this library, and not another copy of it or none. */
  private static boolean sees(ClassLoader loader, Class<?> service) {
    try {
      return loader.loadClass(service.getName()) == service;
    } catch (ClassNotFoundException | LinkageError ignored) {
      return false;
    }
  }

  private static <T> List<T> load(Class<T> service, ClassLoader loader, String name) {
    List<T> found = new ArrayList<>();
    Iterator<T> providers = ServiceLoader.load(service, loader).iterator();
    while (true) {
      try {
        if (!providers.hasNext()) {
          return found;
        }
        found.add(providers.next());
      } catch (ServiceConfigurationError | LinkageError broken) {
        problem(name + broken.getMessage() + cause(broken));
      }
    }
  }

  private static String cause(Throwable broken) {
    return broken.getCause() == null ? "" : " (" + broken.getCause() + ")";
  }

  /**
   * Registers a class loader for the search of providers.
   *
   * @param loader one that sees this library as its parent does
   * @param name of the extension in messages
   */
  public static void register(ClassLoader loader, String name) {
    REGISTERED.addIfAbsent(new Registered(loader, name, new ConcurrentHashMap<>()));
  }

  /**
   * Registers each jar in a folder that is not registered yet, each with a class loader of its own,
   * so that two may bring different versions of a library. A jar without a service of this library
   * is left out and {@link #problems() named}.
   *
   * @param folder a folder; one that does not exist has no jars
   * @return the jars, in the order of their names
   * @throws IOException if the folder cannot be read
   */
  public static List<Path> open(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    List<Path> jars;
    try (Stream<Path> files = Files.list(folder)) {
      jars =
          files
              .filter(file -> file.getFileName().toString().endsWith(".jar"))
              .filter(Files::isRegularFile)
              .sorted()
              .toList();
    } catch (UncheckedIOException unreadable) {
      throw unreadable.getCause();
    }
    for (Path jar : jars) {
      if (OPENED.add(jar.toRealPath())) {
        String name = jar.getFileName().toString();
        ExtensionJar.fault(jar)
            .ifPresentOrElse(
                fault -> problem(name + ": " + fault),
                () -> register(new URLClassLoader(new URL[] {url(jar)}, OWN), name));
      }
    }
    return jars;
  }

  private static URL url(Path jar) {
    try {
      return jar.toUri().toURL();
    } catch (MalformedURLException impossible) {
      throw new IllegalStateException(impossible);
    }
  }

  /**
   * Notes that a provider was left out.
   *
   * @param line which, and why
   */
  public static void problem(String line) {
    PROBLEMS.addIfAbsent(line);
  }

  /**
   * What was left out so far.
   *
   * @return one line each, in the order in which it was found
   */
  public static List<String> problems() {
    return List.copyOf(PROBLEMS);
  }

  /**
   * Whether a provider came from outside of the library's own class loader.
   *
   * @param provider any provider
   * @return true if its class is another loader's
   */
  public static boolean isForeign(Object provider) {
    return provider.getClass().getClassLoader() != OWN;
  }
}
