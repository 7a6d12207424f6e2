package haltere.ui.viewer.action;

import haltere.core.sink.internal.Unchecked;
import java.util.HashMap;
import java.util.Map;

/** The commands of the window by id, from {@code actions.txt}. */
final class ActionTable {
  /**
   * A line of the table; the components are those of {@link ViewerAction}, and the number of the
   * paragraph.
   */
  record ActionLine(String id, String key, String menu, String label, String help, int group) {}

  private static final Map<String, ActionLine> LINES = read();

  private ActionTable() {}

  /** Number of the group of a command; another one for unknown commands. */
  static int group(String id, int other) {
    return LINES.containsKey(id) ? LINES.get(id).group() : other;
  }

  static ActionLine line(String id) {
    ActionLine line = LINES.get(id);
    if (line == null) {
      throw new IllegalArgumentException("actions.txt does not have " + id);
    }
    return line;
  }

  private static Map<String, ActionLine> read() {
    Map<String, ActionLine> lines = new HashMap<>();
    String text = Unchecked.text(ActionTable.class.getResourceAsStream("actions.txt"));
    int group = 0;
    for (String line : text.split("\n")) {
      if (line.isBlank()) {
        group++;
      } else if (!line.startsWith("#")) {
        String[] cell = line.split("\\s*\\|\\s*", -1);
        lines.put(cell[0], new ActionLine(cell[0], cell[1], cell[2], cell[3], cell[4], group));
      }
    }
    return lines;
  }
}
