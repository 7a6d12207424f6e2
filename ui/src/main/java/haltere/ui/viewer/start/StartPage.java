package haltere.ui.viewer.start;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import java.net.URL;
import java.util.List;
import java.util.Optional;
import javafx.geometry.Insets;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Button;
import javafx.scene.control.ContentDisplay;
import javafx.scene.control.Hyperlink;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.FlowPane;
import javafx.scene.layout.HBox;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;

/**
 * The start page: recordings, scenes with pictures and descriptions, cameras; above them, the
 * problem of a failed opening.
 */
final class StartPage extends ScrollPane {
  private static final double PICTURE_WIDTH = 160;
  private static final double PICTURE_HEIGHT = 102;
  private static final double SENTENCE_HEIGHT = 98;
  private static final int MAX_RECENT = 6;

  private final Label problem =
      Controls.named(Controls.paragraph(""), "start-problem", "start-problem");
  private final Button back = Controls.named(new Button(), "start-back");
  private final VBox recent = new VBox(2);
  private final FlowPane scenes = new FlowPane(12, 12);
  private final VBox cameras = new VBox(4);

  /** A page with buttons to open a recording and to go back only. */
  StartPage(Runnable open, Runnable close) {
    Controls.named(this, "start-page", "start-page");
    problem.setMaxWidth(Double.MAX_VALUE);
    setProblem("");
    Button opening =
        Controls.named(new Button("Open recording\u2026"), "start-open", Styles.ACCENT);
    opening.setOnAction(event -> open.run());
    back.setOnAction(event -> close.run());
    setBack(Optional.empty());
    HBox actions =
        Controls.row(
            10, opening, back, Controls.label("or drop a file on the window", Styles.TEXT_MUTED));
    VBox page =
        new VBox(
            10,
            Controls.label("Haltere", Styles.TITLE_2),
            Controls.label(
                "Plays, filters and tracks the events of event cameras.", Styles.TEXT_MUTED),
            problem,
            actions,
            Controls.label("Recent", Styles.TITLE_4),
            recent,
            Controls.label("Scenes", Styles.TITLE_4),
            scenes,
            Controls.label("Cameras", Styles.TITLE_4),
            cameras);
    page.getStyleClass().addAll("start-content");
    page.setMaxWidth(1080);
    Controls.scrolling(this, page);
  }

  /** Shows the problem of a failed opening; empty text hides it. */
  void setProblem(String text) {
    problem.setText(text);
    Controls.show(!text.isEmpty(), problem);
  }

  /** Shows or hides the button back to the open source. */
  void setBack(Optional<String> name) {
    name.ifPresent(open -> back.setText("Back to " + open));
    Controls.show(name.isPresent(), back);
  }

  /** Offers recordings that were open before, the last one first. */
  void setRecent(List<ViewerAction> actions) {
    List<Node> lines = actions.stream().limit(MAX_RECENT).<Node>map(StartPage::recentLine).toList();
    recent
        .getChildren()
        .setAll(
            lines.isEmpty()
                ? List.of(
                    Controls.label("Recordings that you open are listed here.", Styles.TEXT_MUTED))
                : lines);
  }

  private static Node recentLine(ViewerAction action) {
    Label folder = Controls.label(action.help(), Styles.TEXT_MUTED);
    BorderPane.setAlignment(folder, Pos.CENTER_LEFT);
    BorderPane.setMargin(folder, new Insets(0, 0, 0, 8));
    BorderPane line = new BorderPane(folder, null, null, null, link(action, action.help()));
    line.setMinWidth(0);
    return line;
  }

  private static Hyperlink link(ViewerAction action, String accessible) {
    Hyperlink link = Controls.named(new Hyperlink(action.label()), "start-" + action.id());
    link.setAccessibleText(accessible);
    link.setMnemonicParsing(false);
    link.setOnAction(event -> action.work().run());
    return link;
  }

  void setScenes(List<ViewerAction> actions) {
    scenes.getChildren().setAll(actions.stream().map(StartPage::tile).toList());
  }

  private static Node tile(ViewerAction action) {
    Label name = Controls.label(action.label(), Styles.TEXT_BOLD);
    Label sentence = Controls.paragraph(action.help(), Styles.TEXT_MUTED, Styles.TEXT_SMALL);
    sentence.setPrefSize(PICTURE_WIDTH, SENTENCE_HEIGHT);
    sentence.setAlignment(Pos.TOP_LEFT);
    VBox content = new VBox(4, picture(action.id()), name, sentence);
    content.setPrefWidth(PICTURE_WIDTH);
    Button tile = Controls.named(new Button(), "start-" + action.id(), "start-tile");
    tile.setAccessibleText(action.label() + ". " + action.help());
    tile.setContentDisplay(ContentDisplay.GRAPHIC_ONLY);
    tile.setGraphic(content);
    tile.setOnAction(event -> action.work().run());
    return tile;
  }

  /** The picture of a scene, in a frame that is there before it is loaded; empty without one. */
  private static Node picture(String id) {
    StackPane frame = new StackPane();
    frame.getStyleClass().addAll("start-picture");
    frame.setMinSize(PICTURE_WIDTH, PICTURE_HEIGHT);
    URL resource = StartPage.class.getResource(id + ".png");
    if (resource != null) {
      ImageView picture = new ImageView(new Image(resource.toExternalForm(), true));
      picture.setFitWidth(PICTURE_WIDTH);
      picture.setFitHeight(PICTURE_HEIGHT);
      frame.getChildren().add(picture);
    }
    return frame;
  }

  /** Offers cameras that are plugged in. */
  void setCameras(List<ViewerAction> actions, Runnable look) {
    List<Node> lines =
        actions.stream()
            .<Node>map(
                action -> {
                  Hyperlink link = link(action, "Open the camera " + action.label());
                  Controls.help(link, action.help());
                  return link;
                })
            .toList();
    Button again = Controls.button("start-look", Icons.RESET, "Look for cameras", look);
    HBox none =
        Controls.row(8, Controls.label("No camera is plugged in.", Styles.TEXT_MUTED), again);
    cameras.getChildren().setAll(lines.isEmpty() ? List.of(none) : lines);
  }
}
