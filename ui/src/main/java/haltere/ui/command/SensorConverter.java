package haltere.ui.command;

import haltere.core.event.SensorGeometry;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Parses {@code WxH}. */
final class SensorConverter implements ITypeConverter<SensorGeometry> {
  private static final Pattern SIZE = Pattern.compile("(\\d{1,6})[xX](\\d{1,6})");

  @Override
  public SensorGeometry convert(String text) {
    Matcher size = SIZE.matcher(text);
    if (!size.matches()) {
      throw new TypeConversionException(
          "'" + text + "' is no sensor size; write width x height in pixels, such as 346x260");
    }
    try {
      return new SensorGeometry(Integer.parseInt(size.group(1)), Integer.parseInt(size.group(2)));
    } catch (IllegalArgumentException outOfRange) {
      throw new TypeConversionException("'" + text + "': " + outOfRange.getMessage());
    }
  }
}
