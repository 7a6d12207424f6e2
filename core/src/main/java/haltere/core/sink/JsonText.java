package haltere.core.sink;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * One line of JSON that is being written: an object whose values are numbers, texts, truth values
 * and further objects. What is not a finite number is null.
 */
final class JsonText implements RowFields.Values {
  private final ByteArrayOutputStream line = new ByteArrayOutputStream(512);
  private final CsvText ascii = new CsvText(line);
  private boolean first;

  /** Begins an object, the line's own or the value of the last key. */
  JsonText open() {
    ascii.raw('{');
    first = true;
    return this;
  }

  /** Ends the object that was begun last. */
  JsonText close() {
    ascii.raw('}');
    first = false;
    return this;
  }

  /** The name of the value that is written next. */
  JsonText key(String name) {
    if (!first) {
      ascii.raw(',');
    }
    first = false;
    quoted(name);
    ascii.raw(':');
    return this;
  }

  @Override
  public void number(long value) {
    ascii.number(value);
  }

  @Override
  public void number(double value, int decimals) {
    if (Double.isFinite(value)) {
      ascii.number(value, decimals);
    } else {
      nothing();
    }
  }

  @Override
  public void number(float value, int decimals) {
    if (Float.isFinite(value)) {
      ascii.number(value, decimals);
    } else {
      nothing();
    }
  }

  @Override
  public void flag(boolean value) {
    ascii.flag(value);
  }

  @Override
  public void text(CharSequence value) {
    quoted(value);
  }

  @Override
  public void nothing() {
    ascii.raw("null");
  }

  /** All that is not ASCII is escaped, so that the line is the same in every encoding. */
  private void quoted(CharSequence value) {
    ascii.raw('"');
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      if (c == '"' || c == '\\') {
        ascii.raw('\\');
        ascii.raw(c);
      } else if (c >= ' ' && c < 0x7f) {
        ascii.raw(c);
      } else {
        ascii.raw("\\u");
        for (int shift = 12; shift >= 0; shift -= 4) {
          ascii.raw(Character.forDigit(c >> shift & 0xf, 16));
        }
      }
    }
    ascii.raw('"');
  }

  /** Takes the line, with a line feed at its end. */
  byte[] take() {
    ascii.raw('\n');
    try {
      ascii.flush();
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    byte[] bytes = line.toByteArray();
    line.reset();
    return bytes;
  }
}
