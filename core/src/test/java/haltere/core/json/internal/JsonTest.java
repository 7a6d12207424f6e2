package haltere.core.json.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.JsonProblem;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JsonTest {
  @Test
  void valuesOfEveryKindAreReadBack() throws IOException {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("z", Long.MAX_VALUE);
    object.put("a", 0.1);
    object.put("nothing", null);
    object.put("list", Arrays.asList(true, false, "a \"text\" ü \n", List.of(), Map.of()));
    Object again = Json.parse(Json.write(object), "a test");
    assertEquals(object, again);
    assertEquals(new ArrayList<>(object.keySet()), new ArrayList<>(((Map<?, ?>) again).keySet()));
  }

  @Test
  void nonFiniteNumbersAreWrittenAsNull() {
    assertEquals("[\n  null,\n  null\n]", Json.write(List.of(Double.NaN, Float.NEGATIVE_INFINITY)));
  }

  @Test
  void syntaxErrorIsReportedWithLineAndColumn() {
    assertProblem("x.json, line 2, column ", "{\n\"a\" 5}");
    assertProblem("x.json, line 1, column ", "{\"a\": 1, \"a\": 2}");
    assertProblem("x.json, line 1, column ", "[99999999999999999999]");
    assertProblem("x.json, line 1, column ", "[NaN]");
    assertProblem("x.json, line 3, column ", "[\n1,\n");
    assertProblem("x.json, line 2: text follows the end of the JSON value", "{}\n{}");
    assertProblem("x.json: it is empty, a JSON value was expected", " \n");
    assertProblem("x.json, line 1, column ", "[".repeat(100_000));
  }

  private static void assertProblem(String start, String text) {
    JsonProblem problem = assertThrows(JsonProblem.class, () -> Json.parse(text, "x.json"));
    assertTrue(problem.getMessage().startsWith(start), problem.getMessage());
    assertTrue(problem.getMessage().lines().count() == 1, problem.getMessage());
  }

  @Test
  void fileMayStartWithAByteOrderMark(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("x.json");
    Files.writeString(file, "\ufeff[1]");
    assertEquals(List.of(1L), Json.read(file));
  }

  @Test
  void nonUtf8FilesAreRejectedByName(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("x.json");
    Files.write(file, "[\"ü\"]".getBytes(StandardCharsets.ISO_8859_1));
    JsonProblem problem = assertThrows(JsonProblem.class, () -> Json.read(file));
    assertEquals(file + ": this is not UTF-8 text", problem.getMessage());
  }
}
