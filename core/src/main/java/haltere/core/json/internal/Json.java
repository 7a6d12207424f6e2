package haltere.core.json.internal;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import haltere.core.json.JsonProblem;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * JSON as plain Java values: an object is a {@link Map} in the order of the text, an array a {@link
 * List}, a number a {@link Long} or a {@link Double}, and null is null.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class Json {
  private static final String BYTE_ORDER_MARK = "\ufeff";

  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .enable(com.fasterxml.jackson.core.StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .build();

  /** Longest file: chains, cameras and roads are far shorter, and it is read at once. */
  private static final long MAX_BYTES = 16 << 20;

  private Json() {}

  /**
   * Reads a file.
   *
   * @param file UTF-8 text
   * @return its value
   * @throws JsonProblem if the text is not JSON, naming the file and the line
   * @throws IOException if the file cannot be read
   */
  public static Object read(Path file) throws IOException {
    if (Files.exists(file) && !Files.isRegularFile(file)) {
      throw new JsonProblem(file + ": this is a folder, a pipe or a device, not a file");
    }
    if (Files.size(file) > MAX_BYTES) {
      throw new JsonProblem(
          file + ": larger than " + (MAX_BYTES >> 20) + " MiB; name another file");
    }
    try {
      return parse(Files.readString(file), file.toString());
    } catch (CharacterCodingException ignored) {
      throw new JsonProblem(file + ": this is not UTF-8 text");
    }
  }

  /**
   * Reads a text.
   *
   * @param text JSON
   * @param name what to call the text in an error message
   * @return its value
   * @throws JsonProblem if it is not JSON
   */
  public static Object parse(String text, String name) throws JsonProblem {
    String json = text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text;
    try (JsonParser parser = FACTORY.createParser(json)) {
      if (parser.nextToken() == null) {
        throw new JsonProblem(name + ": it is empty, a JSON value was expected");
      }
      Object value = value(parser);
      if (parser.nextToken() != null) {
        throw new JsonProblem(
            name
                + ", line "
                + parser.currentTokenLocation().getLineNr()
                + ": text follows the end of the JSON value");
      }
      return value;
    } catch (JsonProcessingException problem) {
      int line = problem.getLocation() == null ? 1 : problem.getLocation().getLineNr();
      int column = problem.getLocation() == null ? 1 : problem.getLocation().getColumnNr();
      throw new JsonProblem(
          name
              + ", line "
              + line
              + ", column "
              + column
              + ": "
              + words(problem.getOriginalMessage()));
    } catch (JsonProblem problem) {
      throw problem;
    } catch (IOException problem) {
      throw new JsonProblem(name + ": " + problem.getMessage());
    }
  }

  /** Without details of Jackson for programmers. */
  private static String words(String message) {
    return message.replaceAll(": enable `.*| \\(start marker at .*|, from `[^`]*`", "");
  }

  private static Object value(JsonParser parser) throws IOException {
    return switch (parser.currentToken()) {
      case START_OBJECT -> {
        Map<String, Object> object = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          String name = parser.currentName();
          parser.nextToken();
          object.put(name, value(parser));
        }
        yield object;
      }
      case START_ARRAY -> {
        List<Object> array = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          array.add(value(parser));
        }
        yield array;
      }
      case VALUE_STRING -> parser.getText();
      case VALUE_NUMBER_INT -> parser.getLongValue();
      case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      case VALUE_TRUE -> Boolean.TRUE;
      case VALUE_FALSE -> Boolean.FALSE;
      case VALUE_NULL -> null;
      default -> throw new IOException("unexpected " + parser.currentToken());
    };
  }

  /**
   * Writes a value on several lines, indented.
   *
   * @param value maps, iterables, strings, numbers, booleans, enums and null; a double that is not
   *     finite is written as null
   * @return JSON text without a line end behind it
   */
  public static String write(Object value) {
    StringWriter text = new StringWriter();
    try (JsonGenerator generator = FACTORY.createGenerator(text)) {
      DefaultPrettyPrinter printer = new DefaultPrettyPrinter();
      DefaultIndenter indenter = new DefaultIndenter("  ", "\n");
      printer.indentObjectsWith(indenter);
      printer.indentArraysWith(indenter);
      generator.setPrettyPrinter(printer);
      write(generator, value);
    } catch (IOException impossible) {
      throw new IllegalStateException(impossible);
    }
    return text.toString();
  }

  private static void write(JsonGenerator generator, Object value) throws IOException {
    if (value == null) {
      generator.writeNull();
    } else if (value instanceof Map<?, ?> map) {
      generator.writeStartObject();
      for (Map.Entry<?, ?> entry : map.entrySet()) {
        generator.writeFieldName(entry.getKey().toString());
        write(generator, entry.getValue());
      }
      generator.writeEndObject();
    } else if (value instanceof Iterable<?> values) {
      generator.writeStartArray();
      for (Object element : values) {
        write(generator, element);
      }
      generator.writeEndArray();
    } else if (value instanceof Boolean flag) {
      generator.writeBoolean(flag);
    } else if (value instanceof Double || value instanceof Float) {
      double number = ((Number) value).doubleValue();
      if (Double.isFinite(number)) {
        generator.writeNumber(number);
      } else {
        generator.writeNull();
      }
    } else if (value instanceof Number number) {
      generator.writeNumber(number.longValue());
    } else {
      generator.writeString(value.toString());
    }
  }
}
