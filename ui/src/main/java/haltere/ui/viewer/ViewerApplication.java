package haltere.ui.viewer;

import haltere.core.format.ReadOptions;
import haltere.core.stream.internal.Daemon;
import haltere.ui.user.ConfigFolder;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.SourceSettings;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/**
 * Starts JavaFX and the viewer's window.
 *
 * <p>Thread rule: {@link #open} on the program's main thread; the rest is JavaFX's.
 */
public final class ViewerApplication {
  private static final int REHEARSED_PICTURES = 20;

  private ViewerApplication() {}

  /**
   * Opens the window on a recording, or on the built-in scene without one, and returns after it has
   * been closed: empty, or the reason why it could not open. The caller has checked the display and
   * JavaFX's libraries.
   */
  public static Optional<String> open(Optional<Path> file, ReadOptions options) {
    return open(file, options, UserSettings.load(ConfigFolder.ofUser()), window -> {});
  }

  /**
   * Opens the window on the built-in scene as {@link #open} does, without the user's settings, and
   * closes it after some pictures.
   */
  public static Optional<String> rehearse() {
    return open(
        Optional.empty(),
        ReadOptions.DEFAULT,
        UserSettings.inMemory(),
        window ->
            new AnimationTimer() {
              @Override
              public void handle(long now) {
                if (window.context().panels().framesShown() > REHEARSED_PICTURES) {
                  stop();
                  window.context().actions().run("quit");
                }
              }
            }.start());
  }

  /** Opens the window on its start page and returns as {@link #open} does. */
  public static Optional<String> openStartPage() {
    return run(
        UserSettings.load(ConfigFolder.ofUser()),
        window -> window.context().actions().run("start-page"));
  }

  private static Optional<String> open(
      Optional<Path> file,
      ReadOptions options,
      UserSettings settings,
      Consumer<ViewerWindow> opened) {
    SourceSettings sources = new SourceSettings(settings);
    SessionRequest request = sources.withSensor(SessionRequest.of(file, options));
    Optional<String> savedChain = sources.chain(request);
    // prepares the first session while JavaFX starts
    FutureTask<ViewerSession> first = new FutureTask<>(() -> request.firstSession(savedChain));
    Daemon.thread(first, "haltere-first").start();
    String name = file.map(Path::toString).orElse("the fly scene");
    return run(
        settings,
        window -> {
          window.context().sessions().open(first, name);
          opened.accept(window);
        });
  }

  /** Runs JavaFX until the window is closed; the consumer gets the window before it is shown. */
  private static Optional<String> run(UserSettings settings, Consumer<ViewerWindow> begin) {
    CountDownLatch closed = new CountDownLatch(1);
    AtomicReference<Throwable> problem = new AtomicReference<>();
    try {
      Platform.startup(
          () -> {
            try {
              ViewerWindow window = window(settings, closed);
              begin.accept(window);
              window.context().stage().show();
            } catch (RuntimeException | Error broken) {
              problem.set(broken);
              closed.countDown();
            }
          });
      closed.await();
    } catch (InterruptedException interrupted) {
      // the process ends: JavaFX's exit would wait for its thread for ever
      Thread.currentThread().interrupt();
      return Optional.empty();
    } catch (RuntimeException | LinkageError unavailable) {
      return Optional.of("JavaFX cannot open a window here: " + Texts.oneLine(unavailable));
    }
    Platform.exit();
    try {
      settings.save();
    } catch (IOException unwritable) {
      return Optional.of("settings are not kept: " + Texts.oneLine(unwritable));
    }
    return Optional.ofNullable(problem.get())
        .map(
            broken ->
                "the viewer could not start: "
                    + (isAboutFonts(broken)
                        ? "no fonts are installed; install some, such as Debian's fonts-dejavu-core"
                        : Texts.oneLine(broken)));
  }

  /** Without any fonts, JavaFX fails with a null pointer in its own classes. */
  private static boolean isAboutFonts(Throwable problem) {
    return problem instanceof NullPointerException
        && Arrays.stream(problem.getStackTrace())
            .limit(3)
            .anyMatch(frame -> frame.getClassName().startsWith("com.sun.javafx.font"));
  }

  private static ViewerWindow window(UserSettings settings, CountDownLatch closed) {
    Theme.DARK.apply();
    Stage stage = new Stage();
    ViewerWindow window = new ViewerWindow(stage, settings);
    // after the window itself has been closed
    stage.addEventHandler(WindowEvent.WINDOW_HIDDEN, event -> Platform.runLater(closed::countDown));
    return window;
  }
}
