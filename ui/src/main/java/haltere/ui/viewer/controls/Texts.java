package haltere.ui.viewer.controls;

import haltere.core.playback.PlayerStatus;
import haltere.core.settings.Parameter;
import haltere.core.stream.internal.Reason;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.Locale;
import java.util.OptionalLong;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Formats numbers and problems for users. */
public final class Texts {
  private static final double MAX_SLOWDOWN = 1e6;
  private static final Pattern TIME_WITH_UNIT =
      Pattern.compile("(\\d+(?:\\.\\d*)?)\\s*(us|\u00b5s|ms|s)");
  private static final Pattern CLOCK_TIME = Pattern.compile("(?:\\d+:){0,2}\\d+(?:\\.\\d*)?");

  /** Share of the requested speed that counts as reached: measured speeds jitter. */
  private static final double REACHED = 0.95;

  private Texts() {}

  /**
   * A time in a recording, such as 1:02.345; with microseconds, which may be negative, on request,
   * as for slow motion.
   */
  public static String time(long us, boolean withMicros) {
    long abs = Math.abs(us);
    long seconds = abs / 1_000_000;
    String whole =
        seconds >= 3600
            ? String.format(
                Locale.ROOT, "%d:%02d:%02d", seconds / 3600, seconds / 60 % 60, seconds % 60)
            : String.format(Locale.ROOT, "%d:%02d", seconds / 60, seconds % 60);
    String micros = String.format(Locale.ROOT, ".%06d", abs % 1_000_000);
    return (us < 0 ? "\u2212" : "") + whole + (withMicros ? micros : micros.substring(0, 4));
  }

  /**
   * Parses a time into microseconds: 1:02:03.5, 62.345, 250 ms, 1500 us, 3 s; empty for other text.
   */
  public static OptionalLong parseTime(String text) {
    Matcher unit = TIME_WITH_UNIT.matcher(text.strip());
    if (unit.matches()) {
      double factor =
          switch (unit.group(2)) {
            case "ms" -> 1e3;
            case "us", "\u00b5s" -> 1;
            default -> 1e6;
          };
      return OptionalLong.of(Math.round(Double.parseDouble(unit.group(1)) * factor));
    }
    if (!CLOCK_TIME.matcher(text.strip()).matches()) {
      return OptionalLong.empty();
    }
    double seconds = 0;
    for (String part : text.strip().split(":")) {
      seconds = 60 * seconds + Double.parseDouble(part);
    }
    return OptionalLong.of(Math.round(seconds * 1e6));
  }

  /** The achieved speed, with the requested one if that is higher. */
  public static String reached(PlayerStatus status) {
    double now = status.achievedSpeed();
    double rounded = Math.abs(now - 1) < 0.015 ? 1 : now >= 1 ? Math.round(now * 100) / 100.0 : now;
    String label = now >= 0.1 && rounded < 1 ? digits(rounded) + "\u00d7" : speed(rounded);
    return label + (isSlowed(status) ? " of " + speed(status.speed()) : "");
  }

  private static boolean isSlowed(PlayerStatus status) {
    double wanted = Double.isInfinite(status.speed()) ? 0 : status.speed();
    return status.achievedSpeed() > 0 && status.achievedSpeed() < REACHED * wanted;
  }

  /** The bottleneck, if the requested speed is not reached; else empty. */
  public static String limit(PlayerStatus status) {
    if (!isSlowed(status)) {
      return "";
    }
    if (status.sourceIsSlowest()) {
      return "Reading or simulating the source takes most of the time.";
    }
    String stage = status.slowestStage();
    return stage.isEmpty() ? "" : "Most of the time goes to " + title(stage) + ".";
  }

  /** Three digits and a letter for thousands: 1.25 M, 34.2 k, 512. */
  public static String quantity(double value) {
    double abs = Math.abs(value);
    return abs >= 999.5e6
        ? digits(value / 1e9) + " G"
        : abs >= 999.5e3
            ? digits(value / 1e6) + " M"
            : abs >= 999.5 ? digits(value / 1e3) + " k" : digits(value);
  }

  /** An event rate as on the command line: 1.25 Mev/s, 34.2 kev/s, 512 ev/s. */
  public static String rate(double eventsPerSecond) {
    String number = quantity(eventsPerSecond);
    return number + (number.contains(" ") ? "ev/s" : " ev/s");
  }

  /** A count: whole below a thousand. */
  public static String count(long value) {
    return Math.abs(value) < 1000 ? Long.toString(value) : quantity(value);
  }

  /** Three digits. */
  public static String digits(double value) {
    double abs = Math.abs(value);
    int decimals = abs >= 99.95 || abs == 0 ? 0 : abs >= 9.995 ? 1 : 2;
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }

  /** A number of unknown size with about five digits that count. */
  public static String number(double value) {
    double abs = Math.abs(value);
    if (abs != 0 && (abs < 1e-3 || abs >= 1e7)) {
      return String.format(Locale.ROOT, "%.3e", value);
    }
    int decimals = abs >= 1000 ? 1 : abs >= 100 ? 2 : abs >= 10 ? 3 : 4;
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }

  /** A speed: 1\u00d7, 2.38\u00d7, 1/20\u00d7, max. */
  public static String speed(double speed) {
    if (Double.isInfinite(speed)) {
      return "max";
    }
    if (speed >= 0.9995) {
      return (speed == Math.rint(speed) ? Long.toString((long) speed) : digits(speed)) + "\u00d7";
    }
    double slowdown = 1 / speed;
    if (slowdown > MAX_SLOWDOWN) {
      return "0\u00d7"; // practically stopped
    }
    String number = digits(slowdown).replaceAll("\\.?0+$", "");
    return "1/" + (slowdown < 9.5 ? number : Math.round(slowdown)) + "\u00d7";
  }

  /** A time of real life, in the unit that suits it. */
  public static String duration(double us) {
    return us >= 1e6
        ? digits(us / 1e6) + " s"
        : us >= 1e3 ? digits(us / 1e3) + " ms" : digits(us) + " \u00b5s";
  }

  /** Display name of a source: "Simulated road" for the camera {@code simulated:road}. */
  public static String source(String name) {
    String simulated = "simulated:";
    return name.startsWith(simulated)
        ? "Simulated " + name.substring(simulated.length()).replace('-', ' ')
        : name;
  }

  /** Display name of a setting: its label, or its name in words. */
  public static String label(Parameter setting) {
    return setting.label().isEmpty() ? label(setting.name(), setting.unit()) : setting.label();
  }

  /** A name in a settings record as words, without its unit. */
  public static String label(String name, String unit) {
    String own = name.substring(name.lastIndexOf('.') + 1);
    String suffix = unit.replaceAll("[^A-Za-z0-9/]", "").replace("/", "(?:Per)?");
    if (!suffix.isEmpty()) {
      // a maximum count of clusters: the unit is the name
      own = own.replaceFirst("(?<=[A-Za-z0-9])(?<!^m(?:ax|in))(?=[A-Z])(?i:" + suffix + ")$", "");
    }
    String spaced = own.replaceAll("([a-z0-9])([A-Z])", "$1 $2").toLowerCase(Locale.ROOT);
    String whole = spaced.replaceFirst("^(min|max) ", "$1imum ");
    return whole.isEmpty() ? name : capital(whole);
  }

  /** A filter's name as words. */
  public static String title(String name) {
    return capital(name.replace('-', ' '));
  }

  /** A line with a capital at its beginning. */
  public static String capital(String line) {
    return line.isEmpty() ? line : Character.toUpperCase(line.charAt(0)) + line.substring(1);
  }

  /** A unit for display: no sign for a ratio, the Greek letter for micro, raised powers. */
  static String unit(String unit) {
    return switch (unit) {
      case "1" -> "";
      case "us" -> "\u00b5s";
      case "deg" -> "\u00b0";
      default -> unit.replace("^2", "\u00b2").replace("^3", "\u00b3");
    };
  }

  /** A problem in one line, without the wrapping of futures and options of commands. */
  public static String oneLine(Throwable why) {
    if ((why instanceof CompletionException
            || why instanceof ExecutionException
            || why instanceof UncheckedIOException)
        && why.getCause() != null) {
      return oneLine(why.getCause());
    }
    boolean isSilent = why.getMessage() == null || why.getMessage().isBlank();
    String text = isSilent ? why.getClass().getSimpleName() : Reason.of(why);
    return withoutOptions(text.lines().findFirst().orElse(text)).strip();
  }

  /**
   * A message without hints in parentheses to options of the command line, which mean nothing in
   * the window. An option that is the only remedy is named with its command.
   */
  public static String withoutOptions(String message) {
    return message
        .replaceAll(" \\(--[^)]*\\)", "")
        .replaceFirst("--(?=sensor|topic|format aedat2)", "haltere view --");
  }

  /** All details of a problem, for a report. */
  public static String details(Throwable problem) {
    StringWriter text = new StringWriter();
    problem.printStackTrace(new PrintWriter(text));
    return text.toString();
  }
}
