import java.io.*;
import java.math.BigInteger;
import java.net.*;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.*;
import java.security.*;
import java.util.*;
import java.util.jar.*;
import java.util.stream.Stream;
import java.util.zip.*;

/**
 * Lays out a Gradle distribution from the artifacts that Maven's central repository holds, for machines that reach that
 * repository and not the Gradle project's own download site. Where that site answers, does nothing and leaves the
 * download to the wrapper.
 *
 * <p>{@code dev.gradleplugins:gradle-api} redistributes all of Gradle's classes in one jar, with the third-party
 * packages relocated under {@code org.gradle.internal.impldep}. This program moves them back by rewriting the constant
 * pool of each class, and writes beside that one bundle a small jar for each Gradle module, which names its module's
 * dependencies and points at the bundle through its manifest's {@code Class-Path}. That is the layout that Gradle's own
 * module registry reads.
 *
 * <p>Two parts of a full distribution are not in that jar: the plugin that Gradle loads into javac for incremental
 * compilation (so an init script compiles with the JDK's own {@code javac} command), and the Kotlin DSL (so build files
 * are Groovy ones).
 *
 * <p>Usage: {@code java GradleFromMaven.java PROJECT_DIR}. Runs at the same time wait for each other; one that is cut off
 * leaves nothing that the next takes for a distribution.
 */
public class GradleFromMaven {
    private static final String RELOCATED = "org/gradle/internal/impldep/";
    private static final String RELOCATED_DOTS = RELOCATED.replace('/', '.');
    private static final String MODULE_SUFFIX = "-classpath.properties";
    private static final String SERVICES = "META-INF/services/";
    private static final int TIMEOUT_MS = 10_000;

    public static void main(String[] args) throws Exception {
        Path project = Path.of(args[0]);
        Properties wrapper = new Properties();
        try (Reader reader = Files.newBufferedReader(project.resolve("gradle/wrapper/gradle-wrapper.properties"))) {
            wrapper.load(reader);
        }
        String url = wrapper.getProperty("distributionUrl");
        String archive = url.substring(url.lastIndexOf('/') + 1); // gradle-8.8-bin.zip
        String name = archive.replace(".zip", ""); // gradle-8.8-bin
        String version = name.replace("gradle-", "").replace("-bin", "");

        String userHome = System.getenv("GRADLE_USER_HOME");
        Path home = userHome == null || userHome.isEmpty() ? Path.of(System.getProperty("user.home"), ".gradle") : Path.of(userHome);
        // The wrapper names the folder after the MD5 of the URL, in base 36.
        byte[] md5 = MessageDigest.getInstance("MD5").digest(url.getBytes(StandardCharsets.UTF_8));
        Path folder = home.toAbsolutePath().resolve("wrapper/dists").resolve(name).resolve(new BigInteger(1, md5).toString(36));
        Path marker = folder.resolve(archive + ".ok");

        if (answers(url)) return;
        Files.createDirectories(folder);
        try (FileChannel channel = FileChannel.open(folder.resolve("bootstrap.lock"), StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
            channel.lock(); // released with the process, however it ends
            if (Files.exists(marker)) return;
            System.err.println("Gradle " + version + ": its site does not answer, laying it out of Maven artifacts (once, about 20 s) ...");
            Path work = folder.resolve("bootstrap.tmp");
            delete(work);
            copyArtifacts(project.resolve("gradle/bootstrap/pom.xml"), work.resolve("jars"), version);
            layOut(work.resolve("jars"), work.resolve("dist"), version);
            Path dist = folder.resolve("gradle-" + version);
            delete(dist);
            Files.move(work.resolve("dist"), dist, StandardCopyOption.ATOMIC_MOVE);
            delete(work);
            Files.createFile(marker);
        }
    }

    private static boolean answers(String url) {
        try {
            HttpURLConnection connection = (HttpURLConnection) new URL(url).openConnection();
            connection.setRequestMethod("HEAD");
            connection.setConnectTimeout(TIMEOUT_MS);
            connection.setReadTimeout(TIMEOUT_MS);
            return connection.getResponseCode() < 400;
        } catch (IOException e) {
            return false;
        }
    }

    private static void copyArtifacts(Path pom, Path jars, String version) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("mvn", "-q", "-B", "-f", pom.toString(),
                "dependency:copy-dependencies", "-DoutputDirectory=" + jars));
        if (System.getProperty("os.name").startsWith("Windows")) command.addAll(0, List.of("cmd", "/c"));
        Process mvn;
        try {
            mvn = new ProcessBuilder(command).redirectErrorStream(true).start();
        } catch (IOException e) {
            throw fail("Gradle " + version + " is not installed, its site does not answer, and there is no mvn to lay it out of Maven artifacts.");
        }
        mvn.getOutputStream().close();
        String said = new String(mvn.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
        int status = mvn.waitFor();
        if (status != 0) throw fail(said + "\nmvn could not fetch the artifacts of Gradle " + version + ".");
    }

    private static IllegalStateException fail(String message) {
        System.err.println(message);
        System.exit(1);
        return new IllegalStateException(message);
    }

    private static void delete(Path folder) throws IOException {
        if (!Files.exists(folder)) return;
        try (Stream<Path> paths = Files.walk(folder)) {
            for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) Files.delete(path);
        }
    }

    /** Makes the distribution folder DIST of the downloaded jars in the folder JARS. */
    private static void layOut(Path jars, Path dist, String version) throws IOException {
        Path lib = Files.createDirectories(dist.resolve("lib"));
        Files.createDirectories(lib.resolve("plugins"));
        String bundle = "gradle-runtime-bundle-" + version + ".jar";

        List<String> companions = new ArrayList<>();
        Path api = null;
        try (Stream<Path> files = Files.list(jars)) {
            for (Path jar : files.sorted().toList()) {
                String name = jar.getFileName().toString();
                if (name.startsWith("gradle-api-")) {
                    api = jar;
                } else if (name.matches("(groovy|ant|kotlin-stdlib|annotations)-.*\\.jar")) {
                    Files.copy(jar, lib.resolve(name), StandardCopyOption.REPLACE_EXISTING);
                    companions.add(name);
                }
            }
        }
        if (api == null) throw new FileNotFoundException("no gradle-api-" + version + ".jar in " + jars);

        Map<String, Properties> modules = writeBundle(api, lib.resolve(bundle));
        Set<String> externals = new TreeSet<>();
        for (Map.Entry<String, Properties> module : modules.entrySet()) {
            Properties old = module.getValue();
            Collections.addAll(externals, old.getProperty("runtime", "").split(","));
            String text = "projects=" + old.getProperty("projects", "")
                    + "\nruntime=" + bundle + "," + String.join(",", companions)
                    + (old.getProperty("optional") == null ? "" : "\noptional=" + old.getProperty("optional")) + "\n";
            writePointer(lib.resolve(module.getKey() + "-" + version + ".jar"), bundle, module.getKey() + MODULE_SUFFIX, text);
        }
        for (String absent : List.of("gradle-instrumentation-agent", "gradle-java-compiler-plugin", "gradle-installation-beacon")) {
            if (!modules.containsKey(absent)) {
                writePointer(lib.resolve(absent + "-" + version + ".jar"), bundle, absent + MODULE_SUFFIX, "projects=\nruntime=\n");
            }
        }
        for (String external : externals) {
            Path jar = lib.resolve(external);
            if (!external.isBlank() && !Files.exists(jar)) writePointer(jar, bundle, null, null);
        }
        Files.writeString(dist.resolve("gradle.properties"), "org.gradle.internal.instrumentation.agent=false\n");
        Files.writeString(Files.createDirectories(dist.resolve("init.d")).resolve("javac.gradle"), """
                allprojects {
                    tasks.withType(JavaCompile).configureEach {
                        options.incremental = false
                        options.fork = true
                        options.forkOptions.executable = new File(System.getProperty('java.home'), 'bin/javac').path
                    }
                }
                """);
    }

    /** Copies the API jar with the relocation undone; returns the module descriptors found at its root, by module name. */
    private static Map<String, Properties> writeBundle(Path api, Path bundle) throws IOException {
        Map<String, Properties> modules = new TreeMap<>();
        Map<String, StringBuilder> services = new TreeMap<>();
        Set<String> written = new HashSet<>();
        try (ZipFile in = new ZipFile(api.toFile());
             ZipOutputStream out = new ZipOutputStream(new BufferedOutputStream(Files.newOutputStream(bundle)))) {
            out.setLevel(Deflater.BEST_SPEED);
            for (ZipEntry entry : Collections.list(in.entries())) {
                if (entry.isDirectory()) continue;
                String name = entry.getName().startsWith(RELOCATED) ? entry.getName().substring(RELOCATED.length()) : entry.getName();
                byte[] bytes = in.getInputStream(entry).readAllBytes();
                if (name.endsWith(MODULE_SUFFIX) && name.indexOf('/') < 0) {
                    Properties module = new Properties();
                    module.load(new ByteArrayInputStream(bytes));
                    modules.put(name.substring(0, name.length() - MODULE_SUFFIX.length()), module);
                }
                if (name.startsWith("META-INF/versions/") || name.matches("META-INF/[^/]*\\.(SF|RSA|DSA|LIST)") || name.equals("module-info.class")
                        || name.equals(SERVICES + "java.nio.file.spi.FileSystemProvider")) continue; // its provider needs the file system to load
                if (name.startsWith(SERVICES)) {
                    services.computeIfAbsent(undo(name.substring(SERVICES.length())), key -> new StringBuilder())
                            .append(undo(new String(bytes, StandardCharsets.UTF_8))).append('\n');
                } else if (written.add(name)) {
                    put(out, name, name.endsWith(".class") ? undoClass(bytes)
                            : name.matches(".*\\.(properties|xml|txt)") ? undo(new String(bytes, StandardCharsets.ISO_8859_1)).getBytes(StandardCharsets.ISO_8859_1)
                            : bytes);
                }
            }
            // gradle --version asks the absent Kotlin DSL for its version.
            put(out, "gradle-kotlin-dsl-versions.properties", "kotlin=absent\n".getBytes(StandardCharsets.UTF_8));
            for (Map.Entry<String, StringBuilder> service : services.entrySet()) {
                put(out, SERVICES + service.getKey(), service.getValue().toString().getBytes(StandardCharsets.UTF_8));
            }
        }
        return modules;
    }

    private static void writePointer(Path jar, String bundle, String entry, String text) throws IOException {
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.CLASS_PATH, bundle);
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar), manifest)) {
            if (entry != null) put(out, entry, text.getBytes(StandardCharsets.UTF_8));
        }
    }

    private static void put(ZipOutputStream out, String name, byte[] bytes) throws IOException {
        out.putNextEntry(new ZipEntry(name));
        out.write(bytes);
        out.closeEntry();
    }

    private static String undo(String text) {
        return text.contains("impldep") ? text.replace(RELOCATED_DOTS, "").replace(RELOCATED, "") : text;
    }

    /** Rewrites the UTF-8 entries of a class file's constant pool (JVMS 4.4); all names and string literals live there. */
    private static byte[] undoClass(byte[] bytes) throws IOException {
        if (!new String(bytes, StandardCharsets.ISO_8859_1).contains("impldep")) return bytes;
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes));
        ByteArrayOutputStream result = new ByteArrayOutputStream(bytes.length);
        DataOutputStream out = new DataOutputStream(result);
        out.writeInt(in.readInt());
        out.writeInt(in.readInt());
        int count = in.readUnsignedShort();
        out.writeShort(count);
        for (int i = 1; i < count; i++) {
            int tag = in.readUnsignedByte();
            out.writeByte(tag);
            switch (tag) {
                case 1 -> {
                    byte[] utf = undo(new String(in.readNBytes(in.readUnsignedShort()), StandardCharsets.ISO_8859_1)).getBytes(StandardCharsets.ISO_8859_1);
                    out.writeShort(utf.length);
                    out.write(utf);
                }
                case 3, 4, 9, 10, 11, 12, 17, 18 -> out.writeInt(in.readInt());
                case 5, 6 -> {
                    out.writeLong(in.readLong());
                    i++;
                }
                case 7, 8, 16, 19, 20 -> out.writeShort(in.readUnsignedShort());
                case 15 -> {
                    out.writeByte(in.readUnsignedByte());
                    out.writeShort(in.readUnsignedShort());
                }
                default -> throw new IOException("unknown constant pool tag " + tag);
            }
        }
        in.transferTo(out);
        return result.toByteArray();
    }
}
