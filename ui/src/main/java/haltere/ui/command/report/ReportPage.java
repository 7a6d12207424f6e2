package haltere.ui.command.report;

import haltere.core.overlay.MarkStyle;
import haltere.core.sink.internal.SvgPlot;
import haltere.core.sink.internal.Unchecked;
import haltere.ui.rendering.MarkColours;
import haltere.ui.rendering.Pictures;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * An HTML page with embedded tables, plots and pictures. Its colours follow the reader's light or
 * dark setting.
 */
public final class ReportPage {
  /** Colours of curves beside those of left and right wings. */
  private static final int COLOURS = 8;

  /** Colours of curves that follow the reader's light or dark setting. */
  private static final String CURVES = ":root{%s}\n@media (prefers-color-scheme:dark){:root{%s}}\n";

  private final StringBuilder body = new StringBuilder();
  private final String title;

  /** A page with a title. */
  public ReportPage(String title) {
    this.title = SvgPlot.escaped(title);
  }

  /**
   * The SVG colour of a curve: that of its side or identity in pictures, or by the number of
   * earlier curves.
   */
  public static String colour(String key, int number) {
    MarkStyle style = MarkColours.ofCurve(key).orElse(MarkStyle.of(MarkStyle.Role.OBJECT, number));
    return switch (style.role()) {
      case LEFT -> "var(--left)";
      case RIGHT -> "var(--right)";
      default -> "var(--c" + style.identity() % COLOURS + ")";
    };
  }

  private static String colours(boolean dark) {
    List<String> colours = new ArrayList<>();
    colours.add("--left:" + web(MarkStyle.of(MarkStyle.Role.LEFT), dark));
    colours.add("--right:" + web(MarkStyle.of(MarkStyle.Role.RIGHT), dark));
    IntStream.range(0, COLOURS)
        .mapToObj(i -> "--c" + i + ":" + web(MarkStyle.of(MarkStyle.Role.OBJECT, i), dark))
        .forEach(colours::add);
    return String.join(";", colours);
  }

  private static String web(MarkStyle style, boolean dark) {
    return String.format("#%06x", MarkColours.argb(style, dark) & 0xffffff);
  }

  void section(String name) {
    body.append("<h2>").append(SvgPlot.escaped(name)).append("</h2>\n");
  }

  /** Adds names and their values. */
  void facts(Map<String, String> facts) {
    List<List<String>> rows =
        facts.entrySet().stream().map(fact -> List.of(fact.getKey(), fact.getValue())).toList();
    body.append("<table class=\"facts\">").append(rows(rows, true)).append("</table>\n");
  }

  void table(List<String> header, List<List<String>> rows) {
    body.append("<table>").append(row("th", "th", header));
    body.append(rows(rows, false)).append("</table>\n");
  }

  private static String rows(List<List<String>> rows, boolean named) {
    return rows.stream()
        .map(cells -> row(named ? "th" : "td", "td", cells))
        .collect(Collectors.joining());
  }

  private static String row(String first, String others, List<String> cells) {
    StringBuilder row = new StringBuilder("<tr>");
    for (int i = 0; i < cells.size(); i++) {
      String tag = i == 0 ? first : others;
      row.append('<').append(tag).append('>').append(SvgPlot.escaped(cells.get(i)));
      row.append("</").append(tag).append('>');
    }
    return row.append("</tr>\n").toString();
  }

  /** Adds preformatted lines. */
  void text(List<String> lines) {
    body.append("<pre>").append(SvgPlot.escaped(String.join("\n", lines))).append("</pre>\n");
  }

  /** Adds lines that are shown on demand. */
  void folded(String name, List<String> lines) {
    body.append("<details><summary>").append(SvgPlot.escaped(name)).append("</summary>\n");
    text(lines);
    body.append("</details>\n");
  }

  /** Adds an SVG document, below it the colours of its curves by their names, and a sentence. */
  void plot(String svg, Map<String, String> curves, String sentence) {
    body.append("<figure>").append(svg).append("<figcaption>");
    curves.forEach(
        (name, colour) ->
            body.append(
                "<span class=\"key\" style=\"color:%s\">%s</span>"
                    .formatted(colour, SvgPlot.escaped(name))));
    body.append("<span>")
        .append(SvgPlot.escaped(sentence))
        .append("</span></figcaption></figure>\n");
  }

  void sentence(String text) {
    body.append("<p>").append(SvgPlot.escaped(text)).append("</p>\n");
  }

  /** Adds a picture with its alternative text, or says that there are no events for one. */
  void picture(Optional<BufferedImage> drawn, String text) {
    drawn.ifPresentOrElse(picture -> add(picture, text), () -> sentence("No events."));
  }

  private void add(BufferedImage picture, String text) {
    body.append("<img alt=\"").append(SvgPlot.escaped(text)).append("\" width=\"");
    body.append(picture.getWidth()).append("\" src=\"data:image/png;base64,");
    body.append(Base64.getEncoder().encodeToString(Pictures.png(picture))).append("\">\n");
  }

  /** Adds how to do it again: the program's version, and the command as a shell reads it. */
  public void addCommand(String version, String command) {
    section("How to repeat it");
    text(List.of(command));
    facts(Map.of("Version", version));
  }

  /** The page as an HTML document. */
  public String html() {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>"
        + title
        + "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n"
        + Unchecked.text(ReportPage.class.getResourceAsStream("report.css"))
        + CURVES.formatted(colours(false), colours(true))
        + "</style></head><body>\n<h1>"
        + title
        + "</h1>\n"
        + body
        + "</body></html>\n";
  }
}
