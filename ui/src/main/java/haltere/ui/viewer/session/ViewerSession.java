package haltere.ui.viewer.session;

import haltere.core.chain.FilterChain;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.CameraPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.RecordingPlayable;
import haltere.core.stream.StreamHandler;
import haltere.ui.plot.InertialFeed;
import haltere.ui.viewer.chain.StageState;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import java.util.List;
import java.util.Optional;

/**
 * An open session: a playable, its chain, its player and the sink of its pictures.
 *
 * <p>Thread rule: made, prepared and closed on any thread but JavaFX's, because that may wait.
 *
 * @param request the request that it was opened for
 * @param remarks remarks for the user on the reading of the recording
 * @param chain belongs to the thread that plays
 * @param firstStages the stages before the player starts
 * @param display where its pictures are made
 * @param player plays it
 * @param inertial the inertial samples that it plays
 * @param isPrepared whether the player has been started in pause
 */
public record ViewerSession(
    SessionRequest request,
    List<String> remarks,
    FilterChain chain,
    List<StageState> firstStages,
    DisplaySink display,
    Player player,
    InertialFeed inertial,
    boolean isPrepared)
    implements AutoCloseable {

  /** A session whose player has not started. */
  static ViewerSession of(
      Playable playable,
      SessionRequest request,
      FilterChain chain,
      PlayerOptions playerOptions,
      DisplayOptions displayOptions) {
    List<String> remarks =
        playable instanceof RecordingPlayable recording
            ? List.copyOf(recording.reader().remarks())
            : List.of();
    List<StageState> stages = StageState.of(chain);
    DisplaySink display = DisplaySink.onOwnThread(playable.geometry(), chain, displayOptions);
    Player player = new Player(playable, chain, playerOptions);
    InertialFeed inertial = new InertialFeed();
    player.addRawSink(display.beforeChain());
    player.addSink(display);
    player.addSink(StreamHandler.ofSamples(inertial::take));
    return new ViewerSession(request, remarks, chain, stages, display, player, inertial, false);
  }

  /** The opened source, without its buffer. */
  public Playable source() {
    Playable playing = player.playable();
    return playing instanceof BufferedPlayable kept ? kept.source() : playing;
  }

  /** The camera that is open, if it is one. */
  public Optional<CameraPlayable> camera() {
    return source() instanceof CameraPlayable live ? Optional.of(live) : Optional.empty();
  }

  /** The session with its player started in pause: it paints its first slice. */
  ViewerSession prepared() {
    player.start();
    return new ViewerSession(request, remarks, chain, firstStages, display, player, inertial, true);
  }

  /** Starts the player, or resumes it after {@link #prepared}. */
  public void play() {
    if (isPrepared) {
      player.play();
    } else {
      player.start();
    }
  }

  @Override
  public void close() {
    player.close();
    display.close();
    chain.close();
  }
}
