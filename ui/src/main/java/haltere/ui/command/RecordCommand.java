package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Recordings;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.pipeline.SessionRecorder.Limits;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Records cameras. */
@Command(
    name = "record",
    footer = {"", "Example: haltere record recording.aedat4 --duration 10"},
    description = {
      "Record a camera for a given time or until Ctrl+C; the recording is complete then.",
      "Records the first connected camera, or that of --device. With several --device, each has "
          + "its own file, OUT.ID. Its header relates the camera's clock to this computer's.",
      "After unplugging and reconnection, the recording continues in another part "
          + "(OUT-2, OUT-3). The header holds the camera's biases and the chain, see haltere info."
    })
final class RecordCommand extends Subcommand {
  @Parameters(
      paramLabel = "OUT",
      description = "Output file; its ending gives the format, preferably .aedat4.")
  Path out;

  @Option(
      names = "--chain",
      paramLabel = "CHAIN.json",
      description = "A chain of filters applied to the events before they are recorded.")
  Path chainFile;

  @Option(
      names = "--max-size",
      paramLabel = "MB",
      description =
          "Largest size of a file; the recording then continues in another part (OUT-2, OUT-3).")
  Double maxMb;

  @Option(
      names = "--keep-free",
      paramLabel = "MB",
      defaultValue = "256",
      description = "End the recording when the disk has less free space; default 256.")
  double keepFreeMb;

  @Mixin CameraOptionsGroup cameras;
  @Mixin PublishingOptions publishing;
  @Mixin RecordingWritingOptions writing;

  /** A camera with its recording. */
  private record Recorded(
      Camera camera, FilterChain chain, SessionRecorder recorder, LiveRun run) {}

  @Override
  public Integer call() throws IOException {
    cameras.check();
    publishing.check();
    writing.checkRecording(out);
    Limits limits = limits();
    boolean grows = Recordings.forWriting(out).name().equals("aedat4");
    checkNeeded(grows, "an OUT.aedat4, whose size is known while it grows", "--max-size");
    List<String> devices = cameras.devices.isEmpty() ? List.of("") : cameras.devices;
    if (new HashSet<>(devices).size() < devices.size()) {
      throw wrongArguments("a camera is named twice");
    }
    checkNeeded(devices.size() == 1, "a single camera", "--publish");
    for (String device : devices) {
      checkParts(devices.size() == 1 ? out : beside(device));
    }
    List<Recorded> all = new ArrayList<>();
    try (Publishing published = new Publishing(this)) {
      for (String device : devices) {
        all.add(open(device, devices.size() == 1 ? out : beside(device), limits, published));
      }
      LiveRun.run(
          all.stream().map(Recorded::run).toList(),
          cameras.durationS(),
          () -> all.stream().anyMatch(each -> each.recorder().endedEarly().isPresent()));
      close(all);
    } catch (IOException | RuntimeException problem) {
      try {
        close(all);
      } catch (IOException | RuntimeException again) {
        problem.addSuppressed(again);
      }
      all.forEach(this::printFiles);
      throw problem;
    }
    summary(all);
    return OK;
  }

  private static void close(List<Recorded> all) throws IOException {
    for (Recorded recorded : all) {
      recorded.camera().close();
      recorded.recorder().close();
      recorded.chain().close();
    }
  }

  /** Prints the files of a failed recording. */
  private void printFiles(Recorded recorded) {
    for (SessionRecorder.Part part : recorded.recorder().parts()) {
      long came = part.report().received();
      if (Files.exists(part.file())) {
        String written = Quantities.events(part.report().written());
        message("%s holds at least %s of %,d received", part.file(), written, came);
      } else {
        String advice = ".aedat4 keeps what was written";
        message("%s was not kept: none of %,d received; %s", part.file(), came, advice);
      }
    }
  }

  private Limits limits() {
    checkRange(maxMb == null || maxMb >= 2 && maxMb <= 1e9, "--max-size", maxMb, "2 to 1e9 MB");
    checkRange(keepFreeMb >= 0 && keepFreeMb <= 1e9, "--keep-free", keepFreeMb, "0 to 1e9 MB");
    return new Limits(
        maxMb == null ? Long.MAX_VALUE : (long) (maxMb * 1e6), (long) (keepFreeMb * 1e6));
  }

  /** {@code out.aedat4} has {@code out.dvs128-0042.aedat4}. */
  private Path beside(String device) {
    return SessionRecorder.extended(out, "." + device.replaceAll("[^A-Za-z0-9._]+", "-"));
  }

  /** Rejects existing parts, which would block a later part of the recording. */
  private void checkParts(Path file) {
    writing.check(file);
    for (int number = 2; Files.exists(SessionRecorder.part(file, number)); number++) {
      writing.check(SessionRecorder.part(file, number));
    }
  }

  private Recorded open(String device, Path file, Limits limits, Publishing published)
      throws IOException {
    Camera camera = cameras.open(device, true);
    try {
      FilterChain chain = chain(camera.geometry());
      SessionRecorder recorder =
          writing.session(
              file,
              camera,
              () -> chainFile == null ? Optional.empty() : Optional.of(ChainFile.write(chain)),
              limits);
      List<StreamHandler> sinks = new ArrayList<>(publishing.open(chain, published).sinks());
      sinks.add(recorder);
      message("recording " + camera.info().id() + " to " + file);
      LiveRun run = new LiveRun(this, camera, chain, sinks);
      return new Recorded(camera, chain, recorder, run);
    } catch (IOException | RuntimeException problem) {
      camera.close();
      throw problem;
    }
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    return chainFile == null
        ? new FilterChain(geometry)
        : ChainFile.read(chainFile, geometry, this::warning);
  }

  private void summary(List<Recorded> all) throws IOException {
    for (Recorded recorded : all) {
      recorded.run().summary();
      if (recorded.recorder().parts().isEmpty() && recorded.recorder().endedEarly().isEmpty()) {
        reportFailure(recorded.camera().info().id() + " sent no events; nothing was recorded");
      }
      new SessionResults(this, recorded.recorder()).print();
    }
    relate(all);
  }

  /** The clocks of several cameras, by all that is known at the end. */
  private void relate(List<Recorded> all) {
    for (Recorded other : all.subList(Math.min(1, all.size()), all.size())) {
      Recorded first = all.get(0);
      var firstClock = first.camera().clockRelation();
      var otherClock = other.camera().clockRelation();
      if (firstClock.isPresent() && otherClock.isPresent()) {
        long us = firstClock.get().onClockOf(otherClock.get(), 0);
        message(
            "the clock of %s is %d us %s that of %s",
            other.camera().info().id(),
            Math.abs(us),
            us < 0 ? "behind" : "ahead of",
            first.camera().info().id());
      }
    }
  }
}
