package haltere.gradle;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Constructor;
import java.lang.reflect.Field;
import java.lang.reflect.Member;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.gradle.api.DefaultTask;
import org.gradle.api.GradleException;
import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Classpath;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.TaskAction;

/**
 * Lists what a module promises to others: each public type outside of packages named {@code
 * internal} with its public and protected members, one signature a line. The list is in the
 * repository; it is compared with the classes, or written anew.
 */
public abstract class PublicApi extends DefaultTask {
  private static final int PROMISED = Modifier.PUBLIC | Modifier.PROTECTED;

  /** Folders of compiled classes. */
  @Classpath
  public abstract ConfigurableFileCollection getClasses();

  /** What the classes need to be loaded. */
  @Classpath
  public abstract ConfigurableFileCollection getLibraries();

  /** The list of the repository; it need not be there to be written. */
  @Internal
  public abstract RegularFileProperty getKept();

  /** Whether the list is written anew. */
  @Input
  public abstract Property<Boolean> getWriting();

  /** The list of the classes. */
  @OutputFile
  public abstract RegularFileProperty getFound();

  @TaskAction
  void list() throws IOException {
    List<String> found = new ArrayList<>();
    try (URLClassLoader loader =
        new URLClassLoader(
            Stream.concat(getClasses().getFiles().stream(), getLibraries().getFiles().stream())
                .map(PublicApi::url)
                .toArray(URL[]::new),
            ClassLoader.getPlatformClassLoader())) {
      for (String name : names()) {
        describe(Class.forName(name, false, loader), found);
      }
    } catch (ClassNotFoundException e) {
      throw new GradleException("a class cannot be loaded", e);
    }
    Files.write(getFound().get().getAsFile().toPath(), found);
    Path kept = getKept().get().getAsFile().toPath();
    if (getWriting().get()) {
      Files.createDirectories(kept.getParent());
      Files.write(kept, found);
      return;
    }
    List<String> promised = Files.exists(kept) ? Files.readAllLines(kept) : List.of();
    String gone = difference(promised, found, "- ");
    String added = difference(found, promised, "+ ");
    if (!gone.isEmpty() || !added.isEmpty()) {
      throw new GradleException(
          "The public API is not that of " + kept.getFileName()
              + ". Where that is meant, ./gradlew apiDump writes the list anew:\n"
              + gone + added);
    }
  }

  private static String difference(List<String> lines, List<String> without, String sign) {
    List<String> left = new ArrayList<>(lines);
    left.removeAll(without);
    return left.stream().map(line -> sign + line + "\n").collect(Collectors.joining());
  }

  /** Names of the classes outside of internal packages, in alphabetical order. */
  private TreeSet<String> names() throws IOException {
    TreeSet<String> names = new TreeSet<>();
    for (File folder : getClasses().getFiles()) {
      if (folder.isDirectory()) {
        Path root = folder.toPath();
        try (Stream<Path> files = Files.walk(root)) {
          files
              .map(file -> root.relativize(file).toString().replace(File.separatorChar, '.'))
              .filter(name -> name.endsWith(".class") && !name.endsWith("-info.class"))
              .filter(name -> !name.contains(".internal."))
              .forEach(name -> names.add(name.substring(0, name.length() - ".class".length())));
        }
      }
    }
    return names;
  }

  private static void describe(Class<?> type, List<String> lines) {
    for (Class<?> one = type; one != null; one = one.getDeclaringClass()) {
      if ((one.getModifiers() & PROMISED) == 0 || one.isAnonymousClass() || one.isLocalClass()) {
        return;
      }
    }
    lines.add(header(type));
    Stream.of(type.getDeclaredFields(), type.getDeclaredConstructors(), type.getDeclaredMethods())
        .flatMap(Arrays::stream)
        .filter(member -> (member.getModifiers() & PROMISED) != 0 && !member.isSynthetic())
        .map(PublicApi::signature)
        .sorted()
        .forEach(line -> lines.add(type.getName() + ": " + line));
  }

  private static String header(Class<?> type) {
    String text = type.toGenericString();
    if (type.getGenericSuperclass() != null && type.getSuperclass() != Object.class) {
      text += " extends " + type.getGenericSuperclass().getTypeName();
    }
    String parents =
        Arrays.stream(type.getGenericInterfaces())
            .map(java.lang.reflect.Type::getTypeName)
            .sorted()
            .collect(Collectors.joining(", "));
    return parents.isEmpty() ? text : text + " implements " + parents;
  }

  private static String signature(Member member) {
    if (member instanceof Method method) {
      return method.toGenericString();
    }
    return member instanceof Constructor<?> constructor
        ? constructor.toGenericString()
        : ((Field) member).toGenericString();
  }

  private static URL url(File file) {
    try {
      return file.toURI().toURL();
    } catch (MalformedURLException e) {
      throw new UncheckedIOException(e);
    }
  }
}
