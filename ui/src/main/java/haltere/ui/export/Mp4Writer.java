package haltere.ui.export;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * An MP4 film in H.264, made by the program ffmpeg, which is looked for on the machine and gets the
 * pictures by a pipe.
 */
public final class Mp4Writer implements FilmWriter {
  /** System property that names the program where it is not on the path. */
  public static final String PROPERTY = "haltere.ffmpeg";

  private static final long PATIENCE_S = 60;

  private final Path target;
  private final Path partial;
  private final Path said;
  private final double framesPerSecond;
  private final Path program;
  private Process process;
  private OutputStream pipe;
  private byte[] bytes = new byte[0];

  /**
   * Begins a film.
   *
   * @param target where; a file that is there is replaced
   * @param framesPerSecond pictures a second
   * @throws IOException with one line for a person if there is no ffmpeg
   */
  public Mp4Writer(Path target, double framesPerSecond) throws IOException {
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
    said = Files.createTempFile("haltere-ffmpeg", ".txt");
  }

  /**
   * Looks for ffmpeg.
   *
   * @return the program that {@value #PROPERTY} names, or the first on the path
   */
  public static Optional<Path> findProgram() {
    String named = System.getProperty(PROPERTY, "");
    if (!named.isEmpty()) {
      return Optional.of(Path.of(named)).filter(Files::isExecutable);
    }
    boolean windows = System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("win");
    String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
    for (String folder : path.split(File.pathSeparator)) {
      Path found = Path.of(folder).resolve(windows ? "ffmpeg.exe" : "ffmpeg");
      if (Files.isExecutable(found)) {
        return Optional.of(found);
      }
    }
    return Optional.empty();
  }

  @Override
  public void add(BufferedImage image) throws IOException {
    if (process == null) {
      start(image.getWidth(), image.getHeight());
    }
    int pixels = image.getWidth() * image.getHeight();
    int[] rgb = image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    if (bytes.length != 3 * pixels) {
      bytes = new byte[3 * pixels];
    }
    for (int i = 0; i < pixels; i++) {
      bytes[3 * i] = (byte) (rgb[i] >> 16);
      bytes[3 * i + 1] = (byte) (rgb[i] >> 8);
      bytes[3 * i + 2] = (byte) rgb[i];
    }
    try {
      pipe.write(bytes);
    } catch (IOException broken) {
      throw new IOException("ffmpeg stopped: " + lastWords(), broken);
    }
  }

  private void start(int width, int height) throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(
            List.of(
                program.toString(),
                "-hide_banner",
                "-loglevel",
                "error",
                "-y",
                "-f",
                "rawvideo",
                "-pixel_format",
                "rgb24",
                "-video_size",
                width + "x" + height,
                "-framerate",
                String.format(Locale.ROOT, "%.3f", framesPerSecond),
                "-i",
                "-",
                // H.264 as most players take it has even sides
                "-vf",
                "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                "-pix_fmt",
                "yuv420p",
                "-movflags",
                "+faststart",
                "-f",
                "mp4",
                partial.toAbsolutePath().toString()));
    builder.redirectErrorStream(true);
    builder.redirectOutput(said.toFile());
    process = builder.start();
    pipe = new BufferedOutputStream(process.getOutputStream(), 1 << 16);
  }

  private String lastWords() throws IOException {
    List<String> lines = Files.readAllLines(said, StandardCharsets.ISO_8859_1);
    return lines.isEmpty() ? "it did not say why" : lines.get(lines.size() - 1);
  }

  @Override
  public void finish() throws IOException {
    if (process == null) {
      throw new IOException("there are no pictures in this stretch of time");
    }
    try {
      pipe.close();
      if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) {
        throw new IOException("ffmpeg did not come to its end within " + PATIENCE_S + " s");
      }
    } catch (InterruptedException told) {
      Thread.currentThread().interrupt();
      throw new IOException("the export was ended", told);
    }
    if (process.exitValue() != 0) {
      throw new IOException("ffmpeg failed: " + lastWords());
    }
    Files.move(partial, target, StandardCopyOption.REPLACE_EXISTING);
  }

  @Override
  public void close() throws IOException {
    if (process != null && process.isAlive()) {
      process.destroyForcibly();
    }
    Files.deleteIfExists(partial);
    Files.deleteIfExists(said);
  }
}
