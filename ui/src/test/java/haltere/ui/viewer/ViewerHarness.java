package haltere.ui.viewer;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.format.ReadOptions;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.playback.ScenePlayable;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.session.InitialView;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import javafx.application.Platform;
import javafx.event.EventType;
import javafx.geometry.Bounds;
import javafx.geometry.Point2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.control.ButtonBase;
import javafx.scene.control.Labeled;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyCodeCombination;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.robot.Robot;
import javafx.stage.Stage;
import javafx.stage.Window;

/**
 * Opens the real window, clicks and types like a person, and waits for conditions. The same on the
 * headless screen and on a real one.
 *
 * <p>Thread rule: the test's thread; what touches nodes it brings to the JavaFX thread.
 */
public final class ViewerHarness extends JavaFxHarness implements AutoCloseable {
  public final Stage stage;
  public final ViewerWindow window;
  private final Robot robot;
  private final List<Throwable> faults = new CopyOnWriteArrayList<>();

  /** An empty window. */
  public ViewerHarness() {
    this(UserSettings.inMemory());
  }

  /** An empty window, set up as a user has left it. */
  public ViewerHarness(UserSettings settings) {
    Stage[] madeStage = new Stage[1];
    Robot[] madeRobot = new Robot[1];
    window =
        onFx(
            () -> {
              Theme.DARK.apply();
              madeStage[0] = new Stage();
              madeRobot[0] = new Robot();
              ViewerWindow made = new ViewerWindow(madeStage[0], settings);
              madeStage[0].setX(0);
              madeStage[0].setY(0);
              madeStage[0].show();
              return made;
            });
    run(
        () ->
            Thread.currentThread()
                .setUncaughtExceptionHandler((thread, fault) -> faults.add(fault)));
    stage = madeStage[0];
    robot = madeRobot[0];
  }

  /** A window in which the blob moves. */
  public static ViewerHarness withBlob() {
    ViewerHarness harness = new ViewerHarness();
    harness.open(() -> new ScenePlayable(() -> new BlobSource(Long.MAX_VALUE), "blob"));
    return harness;
  }

  /** A window in which the blob moves, with two noise filters before the usual chain. */
  public static ViewerHarness withBlobAndNoiseFilters() {
    ViewerHarness harness = withBlob();
    harness.addNoiseFilters();
    return harness;
  }

  /** A window in which the blob moves, with other filters than usual. */
  static ViewerHarness withBlobAnd(String... filters) {
    ViewerHarness harness = withBlob();
    harness.putFilters(filters);
    return harness;
  }

  /** Puts two noise filters before the usual chain. */
  public void addNoiseFilters() {
    putFilters("background-activity", "hot-pixels", "object-tracker");
  }

  private void putFilters(String... filters) {
    FilterChain chain = new FilterChain(BlobSource.GEOMETRY);
    for (String name : filters) {
      chain.add(Filters.named(name));
    }
    run(() -> window.context().editor().replaceAll(chain));
    waitFor(
        "the cards of all filters",
        () -> Arrays.stream(filters).allMatch(filter -> isThere("stage-" + filter)));
  }

  /** A window that plays a recording of the blob. */
  public static ViewerHarness withRecording(Path folder, long lengthUs) throws IOException {
    Path file = folder.resolve("blob.aedat");
    writeRecording(file, lengthUs);
    ViewerHarness harness = new ViewerHarness();
    harness.openRecording(file);
    return harness;
  }

  /** A recording of two seconds of the blob. */
  public static Path recording(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    writeRecording(file, 2_000_000);
    return file;
  }

  /** Writes the blob in the format that the name of the file says. */
  public static void writeRecording(Path file, long lengthUs) throws IOException {
    try (BlobSource blob = new BlobSource(lengthUs)) {
      writeRecording(file, blob);
    }
  }

  /** Writes the events of a source as the file's name says. */
  public static void writeRecording(Path file, EventSource source) throws IOException {
    try (var writer =
        Recordings.forWriting(file)
            .create(file, WriteOptions.of(source.geometry()))
            .orElseThrow()) {
      source.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              try {
                writer.write(packet);
              } catch (IOException problem) {
                throw new UncheckedIOException(problem);
              }
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
      writer.finish();
    }
  }

  public void open(Callable<Playable> playable) {
    run(
        () ->
            window
                .context()
                .sessions()
                .open(
                    new SessionRequest(
                        playable,
                        Optional.empty(),
                        ReadOptions.DEFAULT,
                        "test",
                        InitialView.OBJECTS)));
    waitFor("a session", () -> window.context().sessions().session().isPresent());
    waitFor("frames", () -> window.context().panels().framesShown() > 0);
    waitFor("what plays", () -> status().elapsedUs() > 0);
  }

  /** Opens a recording, also the one that is open already, and waits until it plays. */
  public void openRecording(Path file) {
    Optional<ViewerSession> before = onFx(() -> window.context().sessions().session());
    run(() -> window.context().sessions().open(file, ReadOptions.DEFAULT));
    waitFor("another session", () -> !window.context().sessions().session().equals(before));
    waitUntilOpen(file.getFileName().toString());
  }

  /** Waits until something of a name is open, be it opened now or long ago. */
  public void waitUntilOpen(String name) {
    waitFor(
        name + " is open",
        () ->
            window.context().sessions().session().isPresent()
                && session().player().playable().name().equals(name)
                && status().eventsIn() > 0);
  }

  public ViewerSession session() {
    return window.context().sessions().session().orElseThrow();
  }

  public PlayerStatus status() {
    return session().player().status();
  }

  /** Pauses and waits until nothing moves any more. */
  public void pause() {
    run(() -> join(session().player().pause()));
    waitFor("pause", () -> status().state() == State.PAUSED);
  }

  // ---- looking

  /** What stands in the status line. */
  @Override
  String said() {
    return find("status-message") instanceof Labeled line ? line.getText() : "";
  }

  /** The node of an id, which must be there. */
  public <T extends Node> T node(String id, Class<T> type) {
    Node found = onFx(() -> find(id));
    assertNotNull(found, "no node #" + id);
    return type.cast(found);
  }

  /** Whether the node of an id is visible in its window, though it may be scrolled out of sight. */
  public boolean isThere(String id) {
    return onFx(
        () -> {
          Node found = find(id);
          return found != null && isVisible(found);
        });
  }

  /** Looks through the window and all of its popups. */
  private static Node find(String id) {
    for (Window window : Window.getWindows()) {
      Parent root = window.getScene() == null ? null : window.getScene().getRoot();
      Node found = root == null || !window.isShowing() ? null : root.lookup("#" + id);
      if (found != null) {
        return found;
      }
    }
    return null;
  }

  public String text(String id) {
    Labeled labeled = node(id, Labeled.class);
    return onFx(labeled::getText);
  }

  /** The part of the window that shows events, as it is drawn. JavaFX thread only. */
  WritableImage picture() {
    return picture("event-view");
  }

  WritableImage picture(String id) {
    Node view = node(id, Node.class);
    Bounds place = view.localToScene(view.getLayoutBounds());
    WritableImage all = stage.getScene().snapshot(null);
    return new WritableImage(
        all.getPixelReader(),
        (int) place.getMinX(),
        (int) place.getMinY(),
        (int) place.getWidth(),
        (int) place.getHeight());
  }

  // ---- hands

  /** Clicks in the middle of a node. */
  public void click(String id) {
    click(id, 0.5, 0.5);
  }

  /** Clicks at a place of a node, in shares of its width and height from its top left corner. */
  public void click(String id, double shareX, double shareY) {
    Node node = node(id, Node.class);
    Callable<Point2D> place =
        () -> {
          Bounds bounds = node.localToScreen(node.getBoundsInLocal());
          return new Point2D(
              bounds.getMinX() + bounds.getWidth() * shareX,
              bounds.getMinY() + bounds.getHeight() * shareY);
        };
    waitFor("#" + id + " is seen", () -> isSeen(node));
    Point2D before;
    do {
      before = onFx(place);
      afterLayout();
    } while (!before.equals(onFx(place)));
    run(
        () -> {
          robot.mouseMove(onFx(place));
          robot.mouseClick(MouseButton.PRIMARY);
        });
  }

  /** Clicks at a place of the sensor in the picture of the events, rows upwards. */
  public void clickAt(double x, double y) {
    EventView view = window.context().panels().view();
    double shareX = onFx(() -> view.viewpoint().viewX(x) / view.getWidth());
    double shareY = onFx(() -> view.viewpoint().viewY(y) / view.getHeight());
    click("event-view", shareX, shareY);
  }

  /** Moves over a share of a node's width, at half its height. */
  void moveOver(String id, double share) {
    Node node = node(id, Node.class);
    run(() -> node.fireEvent(mouse(MouseEvent.MOUSE_MOVED, node, share)));
  }

  /** Presses at a share of a node's width, at half its height, and lets go at another. */
  void drag(String id, double fromShare, double toShare) {
    Node node = node(id, Node.class);
    run(
        () -> {
          node.fireEvent(mouse(MouseEvent.MOUSE_PRESSED, node, fromShare));
          node.fireEvent(mouse(MouseEvent.MOUSE_DRAGGED, node, toShare));
          node.fireEvent(mouse(MouseEvent.MOUSE_RELEASED, node, toShare));
        });
  }

  private static MouseEvent mouse(EventType<MouseEvent> type, Node node, double share) {
    double x = share * node.getLayoutBounds().getWidth();
    double y = node.getLayoutBounds().getHeight() / 2;
    boolean down = type == MouseEvent.MOUSE_PRESSED || type == MouseEvent.MOUSE_DRAGGED;
    return new MouseEvent(
        type,
        x,
        y,
        x,
        y,
        down || type == MouseEvent.MOUSE_RELEASED ? MouseButton.PRIMARY : MouseButton.NONE,
        1,
        false,
        false,
        false,
        false,
        down,
        false,
        false,
        false,
        false,
        false,
        null);
  }

  private static boolean isSeen(Node node) {
    return isVisible(node) && node.getLayoutBounds().getWidth() > 0;
  }

  private static boolean isVisible(Node node) {
    for (Node above = node; above != null; above = above.getParent()) {
      if (!above.isVisible()) {
        return false;
      }
    }
    return true;
  }

  /** Waits until the window has been laid out once more. */
  private void afterLayout() {
    CompletableFuture<Void> laidOut = new CompletableFuture<>();
    Runnable listener = () -> laidOut.complete(null);
    run(
        () -> {
          stage.getScene().addPostLayoutPulseListener(listener);
          Platform.requestNextPulse();
        });
    join(laidOut);
    run(() -> stage.getScene().removePostLayoutPulseListener(listener));
  }

  /**
   * Turns the wheel in the middle of a node. Not by the robot, because headless and real screens do
   * not agree on the direction of its wheel.
   *
   * @param notches away from the person if positive
   */
  void wheel(String id, int notches) {
    Node node = node(id, Node.class);
    run(
        () -> {
          Bounds bounds = node.getLayoutBounds();
          node.fireEvent(scroll(bounds.getCenterX(), bounds.getCenterY(), 40.0 * notches));
        });
  }

  private static ScrollEvent scroll(double x, double y, double deltaY) {
    return new ScrollEvent(
        ScrollEvent.SCROLL,
        x,
        y,
        x,
        y,
        false,
        false,
        false,
        false,
        false,
        false,
        0,
        deltaY,
        0,
        deltaY,
        40,
        40,
        ScrollEvent.HorizontalTextScrollUnits.NONE,
        0,
        ScrollEvent.VerticalTextScrollUnits.NONE,
        0,
        0,
        null);
  }

  private boolean isKeyOfMenu(KeyCode key) {
    return stage.getScene().getAccelerators().keySet().stream()
        .anyMatch(menu -> menu instanceof KeyCodeCombination keys && keys.getCode() == key);
  }

  /**
   * Presses keys together, once a window has the focus; those with Control, but for arrows, once a
   * menu has them, which is when the window was first laid out.
   */
  public void press(KeyCode... keys) {
    waitFor("the focus", () -> Window.getWindows().stream().anyMatch(Window::isFocused));
    if (keys[0] == KeyCode.CONTROL && !keys[keys.length - 1].isArrowKey()) {
      waitFor("the key of a menu", () -> isKeyOfMenu(keys[keys.length - 1]));
    }
    run(
        () -> {
          for (KeyCode key : keys) {
            robot.keyPress(key);
          }
          for (int i = keys.length - 1; i >= 0; i--) {
            robot.keyRelease(keys[i]);
          }
        });
  }

  /** Presses a button wherever it is, also behind another tab. */
  void fire(String id) {
    ButtonBase button = node(id, ButtonBase.class);
    run(button::fire);
  }

  /** Types small letters. */
  void type(String letters) {
    for (char letter : letters.toCharArray()) {
      press(KeyCode.valueOf(String.valueOf(letter).toUpperCase(Locale.ROOT)));
    }
  }

  @Override
  public void close() {
    if (onFx(stage::isShowing)) {
      run(stage::close);
    }
    for (Throwable fault : faults) {
      throw new AssertionError("a fault on the JavaFX thread", fault);
    }
  }
}
