package haltere.gradle;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.TreeMap;
import org.cyclonedx.Version;
import org.cyclonedx.exception.GeneratorException;
import org.cyclonedx.generators.BomGeneratorFactory;
import org.cyclonedx.model.Bom;
import org.cyclonedx.model.Component;
import org.cyclonedx.model.Hash;
import org.cyclonedx.model.LicenseChoice;
import org.cyclonedx.model.Metadata;
import org.cyclonedx.model.license.Expression;
import org.gradle.api.DefaultTask;
import org.gradle.api.GradleException;
import org.gradle.api.artifacts.component.ModuleComponentIdentifier;
import org.gradle.api.artifacts.result.ResolvedArtifactResult;
import org.gradle.api.file.RegularFileProperty;
import org.gradle.api.provider.MapProperty;
import org.gradle.api.provider.Property;
import org.gradle.api.tasks.Input;
import org.gradle.api.tasks.InputFile;
import org.gradle.api.tasks.OutputFile;
import org.gradle.api.tasks.TaskAction;

/**
 * Writes which libraries of others a distribution holds as a bill of materials (CycloneDX 1.5,
 * JSON). The licence of a library is its row in THIRD-PARTY.md; a library without a row fails the
 * build.
 */
public abstract class BillOfMaterials extends DefaultTask {
  private static final String CLASSPATH_EXCEPTION = "GPL-2.0 with the Classpath Exception";

  /** Coordinates ({@code group:name:version}) of the libraries by the paths of their jars. */
  @Input
  public abstract MapProperty<String, String> getLibraries();

  /** Version of the program. */
  @Input
  public abstract Property<String> getVersion();

  /** THIRD-PARTY.md. */
  @InputFile
  public abstract RegularFileProperty getNotices();

  /** The bill of materials. */
  @OutputFile
  public abstract RegularFileProperty getTarget();

  /**
   * Coordinates of artifacts.
   *
   * @param artifacts of libraries and of own modules, which are left out
   * @return as {@link #getLibraries()} takes them
   */
  public static Map<String, String> libraries(Collection<ResolvedArtifactResult> artifacts) {
    Map<String, String> libraries = new TreeMap<>();
    for (ResolvedArtifactResult artifact : artifacts) {
      if (artifact.getId().getComponentIdentifier() instanceof ModuleComponentIdentifier id) {
        libraries.put(artifact.getFile().getPath(), id.toString());
      }
    }
    return libraries;
  }

  @TaskAction
  void write() throws IOException, GeneratorException {
    Component program = component(Component.Type.APPLICATION, "io.github.haltere", "haltere", getVersion().get());
    program.setLicenses(licence("Apache-2.0"));
    Metadata metadata = new Metadata();
    metadata.setTimestamp(null); // the same sources give the same bytes
    metadata.setComponent(program);
    Bom bom = new Bom();
    bom.setMetadata(metadata);
    Map<String, String> licences = licences();
    for (Map.Entry<String, String> library : getLibraries().get().entrySet()) {
      String[] coordinates = library.getValue().split(":");
      if (!licences.containsKey(coordinates[1])) {
        throw new GradleException("THIRD-PARTY.md has no row for " + coordinates[1]);
      }
      bom.addComponent(library(coordinates, new File(library.getKey()), licences.get(coordinates[1])));
    }
    bom.getComponents().sort(Comparator.comparing(Component::getBomRef));
    String json = BomGeneratorFactory.createJson(Version.VERSION_15, bom).toJsonString();
    Files.writeString(getTarget().get().getAsFile().toPath(), json + "\n");
  }

  /** Licences by library, of the rows "| names | licence | address |". */
  private Map<String, String> licences() throws IOException {
    Map<String, String> licences = new HashMap<>();
    for (String line : Files.readAllLines(getNotices().get().getAsFile().toPath())) {
      String[] cells = line.split("\\|");
      if (cells.length == 4 && cells[3].strip().startsWith("http")) {
        for (String name : cells[1].replaceAll("\\(.*\\)", "").split(",")) {
          licences.put(name.strip(), cells[2].strip());
        }
      }
    }
    return licences;
  }

  private static Component library(String[] coordinates, File jar, String licence)
      throws IOException {
    Component library =
        component(Component.Type.LIBRARY, coordinates[0], coordinates[1], coordinates[2]);
    library.setPurl("pkg:maven/" + coordinates[0] + "/" + coordinates[1] + "@" + coordinates[2]);
    library.setBomRef(jar.getName());
    library.setLicenses(licence(licence));
    library.addHash(new Hash(Hash.Algorithm.SHA_256, sha256(jar)));
    return library;
  }

  private static Component component(
      Component.Type type, String group, String name, String version) {
    Component component = new Component();
    component.setType(type);
    component.setGroup(group);
    component.setName(name);
    component.setVersion(version);
    return component;
  }

  private static LicenseChoice licence(String name) {
    LicenseChoice choice = new LicenseChoice();
    choice.setExpression(
        new Expression(
            name.equals(CLASSPATH_EXCEPTION) ? "GPL-2.0-only WITH Classpath-exception-2.0" : name));
    return choice;
  }

  private static String sha256(File file) throws IOException {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      return HexFormat.of().formatHex(digest.digest(Files.readAllBytes(file.toPath())));
    } catch (NoSuchAlgorithmException impossible) {
      throw new IllegalStateException(impossible);
    }
  }
}
