package haltere.testing.architecture;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaField;
import com.tngtech.archunit.core.domain.JavaMember;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The dependency rules of docs/architecture.md. Discuss a rule before you delete it. */
class ArchitectureTest {
  private static final String INTERNAL = "haltere..internal..";

  private static JavaClasses product;

  @BeforeAll
  static void importProduct() {
    product =
        new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(
                location -> !location.contains("/jmh/") && !location.contains("/src-test/build/"))
            .importPackages("haltere");
  }

  /** A rule that is about no class fails. */
  private static void check(ArchRule rule) {
    rule.allowEmptyShould(false).check(product);
  }

  private static void exists(String name) {
    assertTrue(
        product.stream().anyMatch(type -> (type.getPackageName() + ".").startsWith(name + ".")),
        "there is no package " + name + ", so its rule would hold for nothing");
  }

  @Test
  void allModulesAreImported() {
    List.of("core", "device", "filters", "columnar", "ui")
        .forEach(name -> exists("haltere." + name));
  }

  @Test
  void coreDependsOnNoOtherModule() {
    check(
        noClasses()
            .that()
            .resideInAPackage("haltere.core..")
            .should()
            .dependOnClassesThat(
                resideInAPackage("haltere..").and(not(resideInAPackage("haltere.core.."))))
            .because("an embedder takes core alone"));
  }

  @Test
  void coreUsesOnlyTheJdkAndNamedLibrariesEachInItsPackage() {
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core..")
            .and()
            .resideOutsideOfPackages(
                "haltere.core.json.internal",
                "haltere.core.format.internal.aedat4",
                "haltere.core.format.internal.bag",
                "haltere.core.format.internal.compression")
            .should()
            .onlyDependOnClassesThat(resideInAnyPackage("java..", "haltere.core.."))
            .because("a library is a promise to every embedder"));
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core.format.internal.bag")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage(
                    "java..", "haltere.core..", "org.apache.commons.compress.compressors.bzip2"))
            .because("of recordings only the chunks of ROS 1 bags are compressed with bzip2"));
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core.json.internal")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage(
                    "java..", "haltere.core.json..", "com.fasterxml.jackson.core..")));
    check(
        classes()
            .that()
            .resideInAnyPackage(
                "haltere.core.format.internal.aedat4", "haltere.core.format.internal.compression")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage(
                    "java..",
                    "javax.xml.stream..",
                    "haltere.core..",
                    "com.github.luben.zstd..",
                    "net.jpountz.."))
            .because("compression is in one place, and only AEDAT-4 has XML in its header"));
  }

  @Test
  void eventPackageDependsOnlyOnTheJdk() {
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core.event")
            .should()
            .onlyDependOnClassesThat(resideInAnyPackage("java..", "haltere.core.event")));
  }

  @Test
  void streamAndSettingsDependOnlyOnEventsAndJson() {
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core.stream..")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage("java..", "haltere.core.stream..", "haltere.core.event")));
    check(
        classes()
            .that()
            .resideInAPackage("haltere.core.settings")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage(
                    "java..",
                    "haltere.core.settings",
                    "haltere.core.event",
                    "haltere.core.json..")));
  }

  @Test
  void chainFormatCameraAndSimulationAreIndependent() {
    String[] stages = {"chain", "format", "camera", "simulation"};
    for (String stage : stages) {
      for (String other : stages) {
        if (!stage.equals(other)) {
          check(
              noClasses()
                  .that()
                  .resideInAPackage("haltere.core." + stage + "..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage("haltere.core." + other + "..")
                  .because("only pipeline and playback know several stages"));
        }
      }
      check(
          noClasses()
              .that()
              .resideInAPackage("haltere.core." + stage + "..")
              .should()
              .dependOnClassesThat()
              .resideInAnyPackage("haltere.core.pipeline..", "haltere.core.playback.."));
    }
  }

  @Test
  void scenesAreIndependentAndSharedCodeDependsOnNone() {
    String simulation = "haltere.core.simulation.internal";
    String[] scenes = {"fly", "road", "dots", "flight"};
    for (String scene : scenes) {
      check(
          classes()
              .that()
              .resideInAPackage(simulation + "." + scene + "..")
              .should()
              .onlyHaveDependentClassesThat()
              .resideOutsideOfPackages("haltere.core.simulation", simulation + ".sensor")
              .because("a scene is found as a service"));
      for (String other : scenes) {
        if (!scene.equals(other)) {
          check(
              noClasses()
                  .that()
                  .resideInAPackage(simulation + "." + scene + "..")
                  .should()
                  .dependOnClassesThat()
                  .resideInAPackage(simulation + "." + other + ".."));
        }
      }
    }
  }

  @Test
  void viewerPackagesAreLayeredAndFeaturesAreIndependent() {
    String window = "haltere.ui.viewer";
    List<String> parts =
        List.of(
            "controls", "action", "chain", "picture", "playback", "plots", "session", "feature");
    List<String> features =
        List.of("wings", "space", "cameras", "compare", "saving", "road", "file", "start");
    Set<String> all = new TreeSet<>();
    parts.forEach(part -> all.add(window + "." + part));
    features.forEach(feature -> all.add(window + "." + feature));
    all.add(window);
    assertEquals(
        all,
        product.stream()
            .map(JavaClass::getPackageName)
            .filter(name -> (name + ".").startsWith(window + "."))
            .collect(Collectors.toCollection(TreeSet::new)),
        "a new package of the window needs its place here");
    Set<String> above = new TreeSet<>(all);
    for (String part : parts) {
      above.remove(window + "." + part);
      knowsNoneOf(window + "." + part, above, "what is below can be read alone");
    }
    for (String feature : features) {
      Set<String> others = new TreeSet<>(above);
      others.remove(window + "." + feature);
      knowsNoneOf(window + "." + feature, others, "a feature can be taken away");
    }
  }

  @Test
  void lowerPackagesDoNotDependOnHigherOnes() {
    knowsNoneOf(
        "haltere.filters.estimation",
        Set.of("haltere.filters.estimation.motion", "haltere.filters.estimation.internal.example"),
        "an estimator takes whatever model there is");
    knowsNoneOf(
        "haltere.filters.estimation.motion",
        Set.of("haltere.filters.estimation.internal.example"),
        "a motion is one without an example");
    knowsNoneOf(
        "haltere.filters.orientation.camera",
        Set.of("haltere.filters.orientation", "haltere.filters.orientation.internal.axis"),
        "a camera is one without a filter");
    knowsNoneOf(
        "haltere.filters.orientation.internal.axis",
        Set.of("haltere.filters.orientation", "haltere.filters.orientation.line"),
        "a filter of an axis knows no settings of an estimator");
    knowsNoneOf(
        "haltere.filters.wing",
        Set.of(
            "haltere.filters.wing.internal.stroke",
            "haltere.filters.wing.internal.search",
            "haltere.filters.wing.internal.original",
            "haltere.filters.wing.tracker"),
        "results and settings are read without a tracker");
    knowsNoneOf(
        "haltere.filters.wing.internal.stroke",
        Set.of("haltere.filters.wing.internal.search", "haltere.filters.wing.tracker"),
        "a stroke is followed whoever found the fly");
    knowsNoneOf(
        "haltere.filters.wing.internal.search",
        Set.of("haltere.filters.wing.tracker"),
        "a fly is found whoever wants it");
    check(
        classes()
            .that()
            .resideInAPackage("haltere.filters.wing.internal.original")
            .should()
            .onlyHaveDependentClassesThat(
                resideInAPackage("haltere.filters.wing.internal.original")
                    .or(
                        DescribedPredicate.describe(
                            "make the parts of a tracker",
                            type -> type.getSimpleName().equals("TrackerParts"))))
            .because("the tracker of 2006 is there for comparison, and can be taken away"));
    knowsNoneOf(
        "haltere.filters.object",
        Set.of("haltere.filters.cluster", "haltere.filters.track", "haltere.filters.road"),
        "objects are tracked without clusters, whatever they are on");
    knowsNoneOf(
        "haltere.filters.plane",
        Set.of("haltere.filters.cluster", "haltere.filters.track", "haltere.filters.road"),
        "a plane is mapped whoever tracks on it");
    knowsNoneOf(
        "haltere.filters.road",
        Set.of("haltere.filters.cluster", "haltere.filters.track"),
        "crossings are counted whoever tracks");
    knowsNoneOf(
        "haltere.filters.cluster", Set.of("haltere.filters.track"), "clusters know no filter");
    knowsNoneOf(
        "haltere.ui.command.results", Set.of("haltere.ui.command"), "tables know no command");
    knowsNoneOf(
        "haltere.ui.command.terminal",
        Set.of("haltere.ui.command", "haltere.ui.command.results"),
        "a terminal knows no command");
  }

  private static void knowsNoneOf(String one, Set<String> others, String reason) {
    others.forEach(ArchitectureTest::exists);
    check(
        noClasses()
            .that()
            .resideInAPackage(one)
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(others.toArray(String[]::new))
            .because(reason));
  }

  @Test
  void deviceAndFiltersAreIndependentOfEachOtherAndOfTheViewer() {
    check(
        noClasses()
            .that()
            .resideInAPackage("haltere.device..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("haltere.filters..", "haltere.ui..", "javafx.."));
    check(
        noClasses()
            .that()
            .resideInAPackage("haltere.filters..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("haltere.device..", "haltere.ui..", "javafx.."));
  }

  @Test
  void externalLibrariesAreConfinedToTheirPackages() {
    check(
        noClasses()
            .that()
            .resideOutsideOfPackage("haltere.filters..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.ejml.."));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackage("haltere.device.usb..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.usb4java.."));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackage("haltere.spark..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("haltere.spark..", "org.apache.spark..", "scala..")
            .because("nobody needs Spark but who runs it"));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackage("haltere.columnar..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("haltere.columnar..", "org.apache.parquet..", "blue.strategic..")
            .because("tables in Parquet are found as a service"));
    check(
        classes()
            .that()
            .resideInAPackage("haltere.columnar..")
            .should()
            .onlyDependOnClassesThat(
                resideInAnyPackage(
                    "java..",
                    "haltere.core..",
                    "haltere.columnar..",
                    "org.apache.parquet..",
                    "org.apache.hadoop.conf..")));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackages("haltere.ui.viewer..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("javafx..", "com.sun.javafx..", "atlantafx..")
            .because("commands and pictures work without a display"));
    check(
        noClasses()
            .that()
            .resideOutsideOfPackages("haltere.ui", "haltere.ui.command..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("picocli.."));
  }

  @Test
  void algorithmsDoNotDependOnTheChain() {
    check(
        noClasses()
            .that()
            .resideInAPackage("haltere.filters.*..")
            .and()
            // with the classes inside of a filter
            .haveNameNotMatching(".*(Filter|Provider)(\\$.*)?")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("haltere.core.chain..")
            .because("somebody may want the tracker and not our chain"));
  }

  @Test
  void packagesAreFreeOfCycles() {
    check(slices().matching("haltere.core.(**)").should().beFreeOfCycles());
    check(slices().matching("haltere.filters.(**)").should().beFreeOfCycles());
    check(slices().matching("haltere.device.(*)..").should().beFreeOfCycles());
    check(slices().matching("haltere.ui.(*)..").should().beFreeOfCycles());
  }

  @Test
  void publicTypesExposeNoInternalTypes() {
    check(
        classes()
            .that()
            .resideInAnyPackage("haltere.core..", "haltere.filters..")
            .and()
            .resideOutsideOfPackage(INTERNAL)
            .and()
            .arePublic()
            .should(
                new ArchCondition<>("have no internal type in what an embedder sees of them") {
                  @Override
                  public void check(JavaClass type, ConditionEvents events) {
                    internalTypesShownBy(type)
                        .forEach(
                            shown ->
                                events.add(
                                    SimpleConditionEvent.violated(
                                        type, type.getName() + " shows " + shown.getName())));
                  }
                })
            .because("nobody can call it without what is internal"));
  }

  private static Stream<JavaClass> internalTypesShownBy(JavaClass type) {
    Stream<JavaClass> parents =
        Stream.concat(type.getRawSuperclass().stream(), type.getRawInterfaces().stream());
    Stream<JavaClass> members =
        type.getMembers().stream()
            .filter(
                member ->
                    member.getModifiers().contains(JavaModifier.PUBLIC)
                        || member.getModifiers().contains(JavaModifier.PROTECTED))
            .filter(member -> !member.getModifiers().contains(JavaModifier.SYNTHETIC))
            .flatMap(ArchitectureTest::signature);
    return Stream.concat(parents, members).filter(shown -> resideInAPackage(INTERNAL).test(shown));
  }

  private static Stream<JavaClass> signature(JavaMember member) {
    return member instanceof JavaCodeUnit method
        ? Stream.of(
                method.getReturnType().getAllInvolvedRawTypes().stream(),
                method.getParameterTypes().stream()
                    .flatMap(parameter -> parameter.getAllInvolvedRawTypes().stream()))
            .flatMap(types -> types)
        : member instanceof JavaField field
            ? field.getType().getAllInvolvedRawTypes().stream()
            : Stream.empty();
  }

  @Test
  void documentsAndExamplesNameNoInternalPackage() throws IOException {
    Path root = Path.of("").toAbsolutePath().getParent();
    List<Path> texts = new ArrayList<>(List.of(root.resolve("README.md")));
    for (String folder : List.of("docs", "examples", "spark/src")) {
      try (Stream<Path> files = Files.walk(root.resolve(folder))) {
        files
            .filter(file -> file.toString().matches(".*\\.(md|java|kt|py|gradle)"))
            .forEach(texts::add);
      }
    }
    assertTrue(texts.size() > 20, texts::toString);
    for (Path text : texts) {
      assertFalse(
          Files.readString(text).matches("(?s).*haltere\\.[a-z.]*\\binternal\\.\\w.*"),
          text + " names an internal package");
    }
  }

  @Test
  void packagesHaveNoGenericNames() {
    check(
        noClasses()
            .should()
            .resideInAnyPackage("..util..", "..impl..", "..common..", "..helper..", "..misc.."));
  }

  /** The provider of a filter is its {@code Provider} in all filters. */
  @Test
  void noTwoClassesOfAModuleHaveTheSameSimpleName() {
    Map<String, List<JavaClass>> named =
        product.stream()
            .filter(type -> !type.isAnonymousClass() && !type.getName().endsWith("package-info"))
            .filter(type -> type.isTopLevelClass() || !type.getSimpleName().equals("Provider"))
            .collect(
                Collectors.groupingBy(
                    type -> type.getPackageName().split("[.]")[1] + ' ' + type.getSimpleName()));
    assertTrue(named.containsKey("core EventPacket"), "no module was looked at");
    named.values().forEach(types -> assertEquals(1, types.size(), types.toString()));
  }

  @Test
  void packagesHaveAtMost45Classes() {
    product.stream()
        .filter(JavaClass::isTopLevelClass)
        .collect(Collectors.groupingBy(JavaClass::getPackageName, Collectors.counting()))
        .forEach(
            (name, classes) ->
                assertTrue(classes <= 45, name + " has " + classes + " classes: divide it"));
  }

  @Test
  void staticFieldsAreFinal() {
    check(
        fields()
            .that()
            .areStatic()
            .and()
            .doNotHaveModifier(JavaModifier.SYNTHETIC)
            .should()
            .beFinal()
            .because("two pipelines in one program must not meet"));
  }

  @Test
  void wallClocksAreInjected() {
    check(
        noClasses()
            .that()
            .resideInAnyPackage("haltere.core..", "haltere.filters..", "haltere.device..")
            .should()
            .callMethod(System.class, "currentTimeMillis")
            .because("results may not depend on when they are computed"));
  }
}
