package haltere.gradle;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Heading;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;
import org.commonmark.renderer.text.TextContentRenderer;
import org.gradle.api.DefaultTask;
import org.gradle.api.GradleException;
import org.gradle.api.file.ConfigurableFileCollection;
import org.gradle.api.file.DirectoryProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputFile;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.tasks.InputFiles;
import org.gradle.api.tasks.Internal;
import org.gradle.api.tasks.OutputDirectory;
import org.gradle.api.tasks.TaskAction;

/**
 * Makes pages of the Markdown documents: README.md is the first page, pictures are beside them. A
 * link to a file that is no document leads to the repository. A link that leads nowhere fails the
 * build.
 */
public abstract class Site extends DefaultTask {
  private static final List<Extension> EXTENSIONS =
      List.of(TablesExtension.create(), HeadingAnchorExtension.create());
  private static final Pattern ID = Pattern.compile(" id=\"([^\"]+)\"");

  private final Parser parser = Parser.builder().extensions(EXTENSIONS).build();
  private final HtmlRenderer html = HtmlRenderer.builder().extensions(EXTENSIONS).build();

  /** The folder that links are relative to. */
  @Internal
  public abstract DirectoryProperty getRoot();

  /** Documents and pictures. */
  @InputFiles
  public abstract ConfigurableFileCollection getSources();

  /** The page around a document, with {@code @title@}, {@code @top@}, {@code @body@}. */
  @InputFile
  public abstract RegularFileProperty getTemplate();

  /** Where the files of the repository are seen. */
  @Input
  public abstract Property<String> getRepository();

  /** The pages. */
  @OutputDirectory
  public abstract DirectoryProperty getTarget();

  @TaskAction
  void write() throws IOException {
    Path root = getRoot().get().getAsFile().toPath();
    Path target = getTarget().get().getAsFile().toPath();
    clear(target);
    Map<Path, Node> documents = new TreeMap<>();
    for (var file : getSources().getFiles()) {
      Path path = root.relativize(file.toPath());
      if (path.toString().endsWith(".md")) {
        documents.put(path, parser.parse(Files.readString(file.toPath())));
      } else {
        Path copy = target.resolve(path);
        Files.createDirectories(copy.getParent());
        Files.copy(file.toPath(), copy, StandardCopyOption.REPLACE_EXISTING);
      }
    }
    String template = Files.readString(getTemplate().get().getAsFile().toPath());
    List<String> targets = new ArrayList<>();
    for (Map.Entry<Path, Node> document : documents.entrySet()) {
      Path page = page(document.getKey());
      document.getValue().accept(new Links(root, document.getKey(), documents.keySet(), targets));
      write(target.resolve(page), fill(template, page, title(document.getValue()), html.render(document.getValue())));
    }
    for (Path folder : documents.keySet().stream().map(Path::getParent).filter(f -> f != null).collect(Collectors.toSet())) {
      Path index = folder.resolve("index.html");
      write(target.resolve(index), fill(template, index, "Haltere: " + heading(folder), contents(folder, documents)));
    }
    check(target, targets);
  }

  private static void clear(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.sorted(java.util.Comparator.reverseOrder()).toList()) {
        if (!file.equals(folder)) {
          Files.delete(file);
        }
      }
    }
  }

  private static Path page(Path document) {
    String name = document.toString();
    return Path.of(name.equals("README.md") ? "index.html" : name.replaceFirst("\\.md$", ".html"));
  }

  private static String title(Node document) {
    for (Node node = document.getFirstChild(); node != null; node = node.getNext()) {
      if (node instanceof Heading) {
        return TextContentRenderer.builder().build().render(node).strip();
      }
    }
    return "Haltere";
  }

  private static String heading(Path folder) {
    String name = folder.getFileName().toString();
    return name.equals("docs") ? "All pages" : name.substring(0, 1).toUpperCase(java.util.Locale.ROOT) + name.substring(1);
  }

  private static String contents(Path folder, Map<Path, Node> documents) {
    StringBuilder list = new StringBuilder("<h1>").append(heading(folder)).append("</h1>\n<ul>\n");
    documents.keySet().stream()
        .map(Path::getParent)
        .filter(below -> below != null && folder.equals(below.getParent()))
        .distinct()
        .forEach(
            below ->
                list.append("<li><a href=\"%s/index.html\">%s</a></li>\n".formatted(below.getFileName(), heading(below))));
    documents.forEach(
        (path, node) -> {
          if (folder.equals(path.getParent())) {
            list.append("<li><a href=\"")
                .append(page(path.getFileName()))
                .append("\">")
                .append(title(node).replace("&", "&amp;").replace("<", "&lt;"))
                .append("</a></li>\n");
          }
        });
    return list.append("</ul>\n").toString();
  }

  private static String fill(String template, Path page, String title, String body) {
    return template
        .replace("@title@", title.replace("&", "&amp;").replace("<", "&lt;"))
        .replace("@top@", "../".repeat(page.getNameCount() - 1))
        .replace("@body@", body);
  }

  private static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  /** Each link leads to a page, and to a heading of it where it names one. */
  private static void check(Path target, List<String> links) throws IOException {
    Map<Path, Set<String>> ids = new HashMap<>();
    List<String> broken = new ArrayList<>();
    for (String link : links) {
      String[] parts = link.split("#", 2);
      Path page = target.resolve(parts[0]);
      if (!Files.exists(page)) {
        broken.add(link);
      } else if (parts.length > 1) {
        if (!ids.containsKey(page)) {
          Matcher matcher = ID.matcher(Files.readString(page));
          Set<String> found = new HashSet<>();
          while (matcher.find()) {
            found.add(matcher.group(1));
          }
          ids.put(page, found);
        }
        if (!ids.get(page).contains(parts[1])) {
          broken.add(link);
        }
      }
    }
    if (!broken.isEmpty()) {
      throw new GradleException("links that lead nowhere: " + String.join(", ", broken));
    }
  }

  /** Turns the links of a document into those of its page. */
  private final class Links extends AbstractVisitor {
    private final Path root;
    private final Path document;
    private final Set<Path> documents;
    private final List<String> targets;

    Links(Path root, Path document, Set<Path> documents, List<String> targets) {
      this.root = root;
      this.document = document;
      this.documents = documents;
      this.targets = targets;
    }

    @Override
    public void visit(Link link) {
      link.setDestination(destination(link.getDestination()));
      visitChildren(link);
    }

    @Override
    public void visit(Image image) {
      targets.add(resolve(image.getDestination()).toString());
      visitChildren(image);
    }

    private Path resolve(String link) {
      Path from = document.getParent() == null ? Path.of("") : document.getParent();
      return from.resolve(link).normalize();
    }

    private String destination(String link) {
      if (link.matches("[a-z]+:.*")) {
        return link;
      }
      String[] parts = link.split("#", 2);
      String anchor = parts.length > 1 ? "#" + parts[1] : "";
      Path file = parts[0].isEmpty() ? document : resolve(parts[0]);
      if (documents.contains(file)) {
        targets.add(page(file) + anchor);
        return (parts[0].isEmpty() ? "" : relative(page(file))) + anchor;
      }
      if (documents.stream().anyMatch(other -> file.equals(other.getParent()))) {
        return relative(file.resolve("index.html"));
      }
      if (!Files.exists(root.resolve(file))) {
        targets.add(file.toString());
      }
      return getRepository().get() + "/" + file;
    }

    private String relative(Path page) {
      Path from = document.getParent();
      return from == null ? page.toString() : from.relativize(page).toString();
    }
  }
}
