package haltere.ui.export;

import haltere.core.stream.internal.Daemon;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;

/** An MP4 film in H.264, encoded by the program ffmpeg, which gets the pictures by a pipe. */
public final class Mp4Writer implements FilmWriter {
  /** System property with the path of the program, if it is not on the search path. */
  public static final String PROPERTY = "haltere.ffmpeg";

  /** H.264 as most players take it, which has even sides. */
  private static final String ARGUMENTS =
      "-hide_banner -loglevel error -y -f rawvideo -pixel_format argb -video_size %dx%d"
          + " -framerate %.3f -i - -vf pad=ceil(iw/2)*2:ceil(ih/2)*2 -pix_fmt yuv420p"
          + " -movflags +faststart -f mp4";

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** Maximum wait for the end of a killed program. */
  private static final long EXIT_TIMEOUT_S = 5;

  private final Path target;
  private final Path partial;
  private final Path log;
  private final double framesPerSecond;
  private final Path program;
  private final Duration patience;
  private Process process;

  /** A separate thread, so that a blocked program can be abandoned. */
  private final ExecutorService feeder =
      Executors.newSingleThreadExecutor(work -> Daemon.thread(work, "haltere-film"));

  private Future<?> handed = CompletableFuture.completedFuture(null);

  /** Starts a film; replaces an existing file. Fails with one line for the user without ffmpeg. */
  public Mp4Writer(Path target, double framesPerSecond) throws IOException {
    this(target, framesPerSecond, PATIENCE);
  }

  /** Starts a film; the program is killed if it makes no progress for this time. */
  public Mp4Writer(Path target, double framesPerSecond, Duration patience) throws IOException {
    this.patience = patience;
    this.target = target;
    this.framesPerSecond = framesPerSecond;
    program =
        findProgram()
            .orElseThrow(
                () ->
                    new IOException(
                        "MP4 needs the program ffmpeg, which is not on this machine's path;"
                            + " install it, or save a GIF, which needs nothing"));
    partial = target.resolveSibling("." + target.getFileName() + ".part");
    log = Files.createTempFile("haltere-ffmpeg", ".txt");
  }

  /** The program that {@value #PROPERTY} names, or the first ffmpeg on the path. */
  public static Optional<Path> findProgram() {
    String named = System.getProperty(PROPERTY, "");
    Optional<Path> chosen = Optional.of(Path.of(named)).filter(Files::isExecutable);
    return named.isEmpty() ? onPath("ffmpeg") : chosen;
  }

  /** The first program of a name on the path. */
  public static Optional<Path> onPath(String name) {
    boolean windows = System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("win");
    String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
    return Stream.of(path.split(File.pathSeparator))
        .map(folder -> Path.of(folder, windows ? name + ".exe" : name))
        .filter(Files::isExecutable)
        .findFirst();
  }

  @Override
  public void add(BufferedImage image) throws IOException {
    if (process == null) {
      start(image.getWidth(), image.getHeight());
    }
    int[] argb = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    ByteBuffer bytes = ByteBuffer.allocate(Integer.BYTES * argb.length);
    bytes.asIntBuffer().put(argb);
    String late = "ffmpeg has accepted no picture for " + seconds();
    hand(() -> process.getOutputStream().write(bytes.array()), late);
  }

  private void start(int width, int height) throws IOException {
    String words = String.format(Locale.ROOT, ARGUMENTS, width, height, framesPerSecond);
    List<String> command = new ArrayList<>(List.of(words.split(" ")));
    command.add(0, program.toString());
    command.add(partial.toAbsolutePath().toString());
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.redirectErrorStream(true);
    builder.redirectOutput(log.toFile());
    process = builder.start();
  }

  private String lastLogLines() throws IOException {
    List<String> lines = Files.readAllLines(log, StandardCharsets.ISO_8859_1);
    return lines.isEmpty() ? "it did not say why" : lines.get(lines.size() - 1);
  }

  @Override
  public void finish() throws IOException {
    if (process == null) {
      throw new IOException("there are no pictures in this interval");
    }
    String late = "ffmpeg did not end within " + seconds();
    hand(process.getOutputStream()::close, late);
    hand(process::waitFor, late);
    await(late);
    if (process.exitValue() != 0) {
      throw new IOException("ffmpeg failed: " + lastLogLines());
    }
    Files.move(partial, target, StandardCopyOption.REPLACE_EXISTING);
  }

  /** A step that waits for the program. */
  private interface Step {
    void run() throws IOException, InterruptedException;
  }

  /** Queues the next step once the previous one is done. */
  private void hand(Step next, String late) throws IOException {
    await(late);
    handed =
        feeder.submit(
            () -> {
              next.run();
              return null;
            });
  }

  /** Waits for the last step. */
  private void await(String late) throws IOException {
    try {
      handed.get(patience.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException hanging) {
      throw new IOException(late, hanging);
    } catch (InterruptedException interruption) {
      Thread.currentThread().interrupt();
      throw new IOException("the export was ended", interruption);
    } catch (ExecutionException broken) {
      throw new IOException("ffmpeg stopped: " + lastLogLines(), broken);
    }
  }

  private String seconds() {
    return String.format(Locale.ROOT, "%.0f s", patience.toMillis() / 1e3);
  }

  /** {@inheritDoc} A program that is still at work is ended. */
  @Override
  public void close() throws IOException {
    if (process != null) {
      // a file that is still being written could not be deleted for good
      process.destroyForcibly();
      process.onExit().completeOnTimeout(process, EXIT_TIMEOUT_S, TimeUnit.SECONDS).join();
    }
    feeder.shutdownNow();
    Files.deleteIfExists(partial);
    Files.deleteIfExists(log);
  }
}
