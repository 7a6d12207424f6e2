package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import haltere.core.sink.internal.Unchecked;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Windows;
import java.util.ArrayList;
import java.util.List;
import javafx.geometry.Insets;
import javafx.geometry.VPos;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;

/**
 * The manual in a window: the page {@code docs/viewer.md} without pictures and links, as headings,
 * paragraphs, lists and tables.
 */
final class Manual {
  private static final String PAGE = "manual/viewer.md";
  private static final double WIDTH = 820;

  private Manual() {}

  /** Opens the manual beside a window. */
  static void show(Stage owner) {
    VBox page = Controls.named(new VBox(8), "manual");
    page.setPadding(new Insets(16));
    page.getChildren().setAll(nodes(Unchecked.text(Manual.class.getResourceAsStream(PAGE))));
    ScrollPane scroll = new ScrollPane(page);
    scroll.setFitToWidth(true);
    scroll.setFocusTraversable(true);
    scroll.setAccessibleText("Manual");
    Windows.beside(owner, "Manual \u2013 Haltere", scroll, WIDTH, 640).show();
  }

  /** The parts of a page in their order: blocks are separated by empty lines. */
  static List<Node> nodes(String markdown) {
    List<Node> nodes = new ArrayList<>();
    boolean code = false;
    StringBuilder block = new StringBuilder();
    for (String line : (markdown + "\n\n").split("\n", -1)) {
      if (line.startsWith("```")) {
        code = !code;
        continue;
      }
      boolean ends = line.isBlank() && !code;
      boolean begins = line.startsWith("- ") || line.startsWith("#");
      if ((ends || begins) && !block.isEmpty()) {
        add(nodes, block.toString().strip());
        block.setLength(0);
      }
      if (!ends) {
        block.append(line).append('\n');
      }
    }
    return nodes;
  }

  private static void add(List<Node> nodes, String block) {
    if (block.startsWith("|")) {
      nodes.add(table(block));
    } else if (block.startsWith("#")) {
      Label heading = label(block.replaceFirst("^#+ *", ""));
      heading.getStyleClass().add(block.startsWith("##") ? Styles.TITLE_4 : Styles.TITLE_2);
      nodes.add(heading);
    } else if (block.startsWith("- ")) {
      Label item = label("\u2022 " + block.substring(2));
      item.setPadding(new Insets(0, 0, 0, 12));
      nodes.add(item);
    } else if (!plain(block).isBlank()) {
      nodes.add(label(block));
    }
  }

  private static Label label(String markdown) {
    return Controls.paragraph(plain(markdown));
  }

  /** The text of a block in one line, without pictures, links and emphasis. */
  static String plain(String markdown) {
    return markdown
        .replaceAll("!\\[[^\\]]*\\]\\([^)]*\\)", "")
        .replaceAll("\\[([^\\]]*)\\]\\([^)]*\\)", "$1")
        .replaceAll("\\*\\*|`", "")
        .replaceAll("\\s+", " ")
        .strip();
  }

  private static GridPane table(String block) {
    GridPane grid = new GridPane(14, 4);
    int row = 0;
    for (String line : block.split("\n")) {
      if (line.matches("[|\\-: ]+")) {
        continue;
      }
      String[] cells = line.strip().replaceAll("^\\||\\|$", "").split("\\|");
      for (int column = 0; column < cells.length; column++) {
        Label cell = label(cells[column]);
        cell.setMaxWidth(column == 0 ? 230 : 520);
        if (row == 0) {
          cell.getStyleClass().add(Styles.TEXT_BOLD);
        }
        GridPane.setValignment(cell, VPos.TOP);
        grid.add(cell, column, row);
      }
      row++;
    }
    return grid;
  }
}
