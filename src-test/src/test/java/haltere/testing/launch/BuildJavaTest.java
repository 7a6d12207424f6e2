package haltere.testing.launch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A Java version that Gradle does not support is reported in one line. */
class BuildJavaTest {
  @TempDir Path folder;

  @BeforeEach
  void needsAShell() {
    Assumptions.assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "this is a script for a shell");
  }

  /** Makes what looks like the JDK of a version and asks the script that gradlew asks. */
  private String errorOf(String version, int status) throws IOException, InterruptedException {
    Path jdk = Files.createDirectories(folder.resolve("jdk-" + version + "/bin")).getParent();
    Files.writeString(jdk.resolve("release"), "JAVA_VERSION=\"" + version + "\"\n");
    Path java = jdk.resolve("bin/java");
    Files.writeString(java, "#!/bin/sh\nexit 0\n");
    assertTrue(java.toFile().setExecutable(true));
    Path root = Path.of("").toAbsolutePath().getParent();
    ProcessBuilder gradlew =
        new ProcessBuilder("/bin/sh", "gradle/bootstrap/install.sh", root.toString())
            .directory(root.toFile())
            .redirectErrorStream(true);
    gradlew.environment().put("GRADLE_BOOTSTRAP_JAVA", java.toString());
    Process process = gradlew.start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertTrue(process.waitFor(30, TimeUnit.SECONDS));
    assertEquals(status, process.exitValue(), said);
    return said;
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.8.0_392", "11.0.21", "25.0.1"})
  void unsupportedJavaVersionIsReportedInOneLine(String version) throws Exception {
    String said = errorOf(version, 1);
    assertEquals(1, said.lines().count(), said);
    assertTrue(said.contains("jdk-" + version) && said.contains("set JAVA_HOME"), said);
  }

  @Test
  void supportedJavaVersionIsAcceptedSilently() throws Exception {
    assertEquals("", errorOf("17.0.9", 0));
    assertEquals("", errorOf("21", 0));
  }
}
