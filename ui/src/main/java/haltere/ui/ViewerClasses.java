package haltere.ui;

import java.io.File;
import java.io.IOException;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;

/**
 * Loads the classes of the viewer and of JavaFX without running them, so that a JVM that was
 * started with {@code -XX:ArchiveClassesAtExit} keeps them in an archive. From that they are mapped
 * in a moment; loading them one by one is a quarter of the time until the window shows events. The
 * build runs this, no user does.
 */
final class ViewerClasses {
  /**
   * What the viewer never uses: other systems' windows, and graphics cards' effects by the dozen.
   */
  private static final List<String> UNUSED =
      List.of(
          "META-INF.",
          "module-info",
          "com.sun.glass.ui.mac.",
          "com.sun.glass.ui.win.",
          "com.sun.glass.ui.ios.",
          "com.sun.glass.ui.android.",
          "com.sun.prism.d3d.",
          "com.sun.scenario.effect.impl.",
          "org.ejml.");

  private ViewerClasses() {}

  /**
   * Loads them.
   *
   * @param args none
   * @throws IOException if a jar cannot be read
   */
  public static void main(String[] args) throws IOException {
    loadAll(System.getProperty("jdk.module.path", ""));
    loadAll(System.getProperty("java.class.path"));
  }

  private static void loadAll(String path) throws IOException {
    for (String entry : path.split(File.pathSeparator)) {
      File place = new File(entry);
      File[] inside = place.listFiles((folder, name) -> name.endsWith(".jar"));
      for (File jar : inside == null ? new File[] {place} : inside) {
        if (jar.getName().endsWith(".jar")) {
          load(jar);
        }
      }
    }
  }

  private static void load(File file) throws IOException {
    try (JarFile jar = new JarFile(file)) {
      jar.stream()
          .map(JarEntry::getName)
          .filter(name -> name.endsWith(".class"))
          .map(name -> name.substring(0, name.length() - ".class".length()).replace('/', '.'))
          .filter(name -> UNUSED.stream().noneMatch(name::startsWith))
          .forEach(ViewerClasses::load);
    }
  }

  private static void load(String name) {
    try {
      Class.forName(name, false, ViewerClasses.class.getClassLoader());
    } catch (ClassNotFoundException | LinkageError notHere) {
      // an optional part of a library; the viewer does without it
      return;
    }
  }
}
