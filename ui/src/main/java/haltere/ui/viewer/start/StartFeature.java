package haltere.ui.viewer.start;

import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.WindowFeature;
import java.util.Optional;

/**
 * The start page: shown while nothing is open, and on request. Its entries are the actions of the
 * menus of recent files, scenes and cameras.
 */
public final class StartFeature extends WindowFeature {
  private static final String RECENT = "File/Open recent";
  private static final String SCENES = "File/Open scene";
  private static final String CAMERAS = "Camera/Open";

  private Optional<StartPage> page = Optional.empty();

  @Override
  protected void install() {
    window.actions().add("start-page", () -> show(""));
    window.actions().onChange(() -> page.ifPresent(this::offerCameras));
    window.sessions().onChange((was, is) -> hide());
    window
        .sessions()
        .onProblem(
            (name, problem) -> {
              if (window.sessions().session().isEmpty() || page.isPresent()) {
                show(name + " cannot be opened.\n" + reason(name, problem));
              }
            });
  }

  /** The reason without the file's name, which is shown above it. */
  private static String reason(String name, Exception problem) {
    String line = Texts.oneLine(problem);
    return Texts.capital(line.startsWith(name + ": ") ? line.substring(name.length() + 2) : line);
  }

  private void show(String problem) {
    ViewerActions actions = window.actions();
    if (page.isEmpty()) {
      StartPage made = new StartPage(() -> actions.run("open"), this::hide);
      page = Optional.of(made);
      made.setScenes(actions.inMenu(SCENES));
      offerCameras(made);
      window.panels().showPage(Optional.of(made));
      actions.run("list-cameras");
    }
    page.get().setRecent(actions.inMenu(RECENT));
    page.get().setProblem(problem);
    page.get().setBack(window.sessions().session().map(open -> open.player().playable().name()));
  }

  /** The other links remain while cameras are listed, so that a click on them is not lost. */
  private void offerCameras(StartPage made) {
    ViewerActions actions = window.actions();
    made.setCameras(actions.inMenu(CAMERAS), () -> actions.run("list-cameras"));
  }

  private void hide() {
    if (page.isPresent()) {
      page = Optional.empty();
      window.panels().showPage(Optional.empty());
    }
  }
}
