package haltere.ui.viewer.session;

import haltere.core.chain.FilterChain;
import haltere.core.playback.CameraPlayable;
import haltere.core.playback.KeptPlayable;
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
 * What is open: a playable, the chain it goes through, the player and the sink that makes pictures.
 *
 * <p>Thread rule: made, prepared and closed on any thread but JavaFX's, because that may wait.
 */
public final class ViewerSession implements AutoCloseable {
  private final SessionRequest request;
  private final FilterChain chain;
  private final List<StageState> firstStages;
  private final DisplaySink display;
  private final Player player;
  private final List<String> remarks;
  private final InertialFeed inertial = new InertialFeed();
  private volatile boolean prepared;

  ViewerSession(
      Playable playable,
      SessionRequest request,
      FilterChain chain,
      PlayerOptions playerOptions,
      DisplayOptions displayOptions) {
    this.request = request;
    this.remarks =
        playable instanceof RecordingPlayable recording
            ? List.copyOf(recording.reader().remarks())
            : List.of();
    this.chain = chain;
    this.firstStages = StageState.of(chain);
    this.display = DisplaySink.apart(playable.geometry(), chain, displayOptions);
    this.player = new Player(playable, chain, playerOptions);
    player.addRawSink(display::beforeChain);
    player.addSink(display);
    player.addSink(StreamHandler.ofSamples(inertial::take));
  }

  /** What a user should know about how the recording is read, as it was opened. */
  public List<String> remarks() {
    return remarks;
  }

  /** What was asked for: where it is, what the user said of it, and how it begins. */
  public SessionRequest request() {
    return request;
  }

  /** What was opened, whether its newest events are kept or not. */
  public Playable source() {
    Playable playing = player.playable();
    return playing instanceof KeptPlayable kept ? kept.source() : playing;
  }

  /** The camera that is open, if it is one. */
  public Optional<CameraPlayable> camera() {
    return source() instanceof CameraPlayable live ? Optional.of(live) : Optional.empty();
  }

  /** The chain, which belongs to the thread that plays. */
  public FilterChain chain() {
    return chain;
  }

  /** The stages before the player starts. */
  public List<StageState> firstStages() {
    return firstStages;
  }

  /** Where its pictures are made. */
  public DisplaySink display() {
    return display;
  }

  /** The inertial samples that it plays. */
  public InertialFeed inertial() {
    return inertial;
  }

  /** Plays it. */
  public Player player() {
    return player;
  }

  /** Starts a player whose options say that it begins in pause: it paints its first slice. */
  void prepare() {
    prepared = true;
    player.start();
  }

  /** Starts the player, or lets it go on once it was {@link #prepare prepared}. */
  public void play() {
    if (prepared) {
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
