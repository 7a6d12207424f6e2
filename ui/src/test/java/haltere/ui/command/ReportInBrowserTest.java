package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import haltere.ui.export.Mp4Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A report in a headless browser; skipped without Chromium on the path. */
class ReportInBrowserTest {
  /**
   * Shows a page in a narrow frame, refuses everything from outside, and notes what the page has.
   */
  private static final String FRAME =
      """
      <!DOCTYPE html><meta http-equiv="Content-Security-Policy" content="default-src 'none';
      img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
      <body><pre></pre><script>
      function note(frame) {
        const page = frame.contentDocument;
        const all = query => [...page.querySelectorAll(query)];
        document.querySelector("pre").textContent = [
          all("h1, h2").map(heading => heading.textContent).join("|"),
          "plots " + all("svg").filter(plot => plot.getBoundingClientRect().height > 100).length,
          "pictures " + all("img").filter(picture => picture.naturalWidth > 0).length,
          "requests " + frame.contentWindow.performance.getEntriesByType("resource").length,
          "excess " + [page.documentElement, ...all(".facts")]
            .map(node => node.scrollWidth - node.clientWidth)].join("\\n");
      }
      </script><iframe width="400" height="900" style="border:0" onload="note(this)" srcdoc="%s">
      </iframe></body>
      """;

  @TempDir Path folder;

  @Test
  void reportIsReadableInANarrowWindowWithoutNetworkAndErrors() throws Exception {
    Optional<Path> chromium = Mp4Writer.onPath("chromium");
    assumeTrue(chromium.isPresent(), "no chromium on the path");
    Path dots = folder.resolve("a-rather-long-name-of-a-recording-of-moving-dots.aedat");
    assertEquals(0, CommandRun.of("simulate", "dots", dots, "--duration", "0.2").status());
    Path report = folder.resolve("report.html");
    Path table = folder.resolve("tracks.csv");
    CommandRun run = CommandRun.of("track", dots, "--out", table, "--report", report);
    assertEquals(0, run.status(), run.err());
    String page = Files.readString(report).replace("&", "&amp;").replace("\"", "&quot;");
    Path frame = Files.writeString(folder.resolve("frame.html"), FRAME.formatted(page));
    Path dom = folder.resolve("dom.html");
    Path log = folder.resolve("browser.log");
    Process browser =
        new ProcessBuilder(
                chromium.get().toString(),
                "--headless",
                "--no-sandbox",
                "--disable-gpu",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--enable-logging=stderr",
                "--user-data-dir=" + folder.resolve("profile"),
                "--dump-dom",
                frame.toUri().toString())
            .redirectOutput(dom.toFile())
            .redirectError(log.toFile())
            .start();
    try {
      assertTrue(browser.waitFor(30, TimeUnit.SECONDS), "the browser ends");
    } finally {
      browser.destroyForcibly();
    }
    String seen = Files.readString(dom);
    seen = seen.substring(seen.indexOf("<pre>") + 5, seen.indexOf("</pre>"));
    assertEquals(
        """
        haltere track: %s|Input|Chain|Results|Objects of object-tracker|Pictures of events \
        and results|Plots|How to repeat it
        plots 3
        pictures 1
        requests 0
        excess 0,0,0"""
            .formatted(dots.getFileName()),
        seen);
    assertFalse(Files.readString(log).contains("CONSOLE"), () -> "errors in " + log);
  }
}
