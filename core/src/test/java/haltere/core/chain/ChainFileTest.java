package haltere.core.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.json.JsonProblem;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ChainFileTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(10, 8);

  @Test
  void chainIsReadWithOrderSwitchesSettingsAndNesting() throws IOException {
    FilterChain chain =
        parse(
            """
            {"comment": "a test", "filters": [
              {"filter": "every-nth", "settings": {"n": 5, "extras": {"ratio": 0.25}}},
              {"name": "inner", "enabled": false, "filters": [
                {"filter": "every-nth", "enabled": false, "settings": {"start": "after-full-round"}}
              ]}
            ]}
            """);
    assertEquals("every-nth", chain.stages().get(0).name());
    assertEquals(
        new EveryNthFilter.Settings(
            5, EveryNthFilter.Start.AT_FIRST_EVENT, new EveryNthFilter.Extras(0.25)),
        settings(chain, 0));
    ChainStage inner = chain.stages().get(1);
    assertEquals("inner", inner.name());
    assertFalse(inner.isEnabled());
    FilterChain nested = (FilterChain) inner.filter();
    assertFalse(nested.stages().get(0).isEnabled());
    assertEquals(
        new EveryNthFilter.Settings(
            2, EveryNthFilter.Start.AFTER_FULL_ROUND, new EveryNthFilter.Extras(0.5)),
        settings(nested, 0));
  }

  @Test
  void writtenChainsAreReadBackUnchanged() throws IOException {
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-nth", new EveryNthFilter(EveryNthFilter.Settings.of(7)));
    FilterChain nested = new FilterChain(SENSOR);
    nested.add("every-nth", new EveryNthFilter(EveryNthFilter.Settings.of(9)), false, 0);
    chain.add("inner", nested);
    String text = ChainFile.write(chain);
    FilterChain again = parse(text);
    assertEquals(text, ChainFile.write(again));
    assertEquals(EveryNthFilter.Settings.of(7), settings(again, 0));
    assertEquals(
        """
        {
          "filters" : [
            {
              "filter" : "every-nth",
              "enabled" : true,
              "settings" : {
                "n" : 7,
                "start" : "at-first-event",
                "extras" : {
                  "ratio" : 0.5
                }
              }
            },
            {
              "name" : "inner",
              "enabled" : true,
              "filters" : [
                {
                  "filter" : "every-nth",
                  "enabled" : false,
                  "settings" : {
                    "n" : 9,
                    "start" : "at-first-event",
                    "extras" : {
                      "ratio" : 0.5
                    }
                  }
                }
              ]
            }
          ]
        }
        """,
        text);
  }

  @Test
  void unknownFiltersAreRejectedWithTheListOfFilters() {
    String message = problem("{\"filters\": [{\"filter\": \"wings\"}]}");
    assertTrue(
        message.startsWith(
            "chain.json: filter 1 (wings): there is no filter named wings; there are "),
        message);
    assertTrue(message.contains("every-nth"), message);
  }

  @Test
  void unknownSettingsAreRejectedWithTheListOfSettings() {
    assertEquals(
        "chain.json: filter 1 (every-nth): there is no setting m; there are n, start, extras.ratio",
        problem("{\"filters\": [{\"filter\": \"every-nth\", \"settings\": {\"m\": 1}}]}"));
    assertEquals(
        "chain.json: filter 1 (every-nth): there is no setting extras.rate;"
            + " there are n, start, extras.ratio",
        problem(withSettings("\"extras\": {\"rate\": 1}")));
    assertEquals(
        "chain.json: filter 1 (every-nth): there is no setting extras;"
            + " there are n, start, extras.ratio",
        problem(withSettings("\"extras\": 1")));
  }

  @Test
  void valueOutOfRangeIsReportedWithTheRange() {
    assertEquals(
        "chain.json: filter 1 (every-nth): setting n is 101, it must be 1 to 100 events",
        problem(withSettings("\"n\": 101")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting n is 99999999999, it must be 1 to 100 events",
        problem(withSettings("\"n\": 99999999999")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting extras.ratio is -0.1, it must be 0 to 1",
        problem(withSettings("\"extras\": {\"ratio\": -0.1}")));
  }

  @Test
  void valueOfTheWrongTypeIsReportedWithTheExpectedType() {
    assertEquals(
        "chain.json: filter 1 (every-nth): setting n is 2.5, it must be a whole number",
        problem(withSettings("\"n\": 2.5")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting n is null, it must be a whole number",
        problem(withSettings("\"n\": null")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting n is {}, it must be a whole number",
        problem(withSettings("\"n\": {}")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting start is now,"
            + " it must be one of at-first-event, after-full-round",
        problem(withSettings("\"start\": \"now\"")));
    assertEquals(
        "chain.json: filter 1 (every-nth): setting extras.ratio is much, it must be a number",
        problem(withSettings("\"extras\": {\"ratio\": \"much\"}")));
  }

  @Test
  void nanIsRejectedAsJsonAndAsText() {
    String json = problem(withSettings("\"extras\": {\"ratio\": NaN}"));
    assertTrue(json.startsWith("chain.json, line 1, column "), json);
    assertTrue(json.contains("NaN"), json);
    assertEquals(
        "chain.json: filter 1 (every-nth): setting extras.ratio is NaN, it must be 0 to 1",
        problem(withSettings("\"extras\": {\"ratio\": \"NaN\"}")));
  }

  @Test
  void orderOfValuesDoesNotMatterIfOnlyTheWholeIsValid() throws IOException {
    FilterChain chain = parse(withSettings("\"extras\": {}, \"n\": 1e1"));
    assertEquals(EveryNthFilter.Settings.of(10), settings(chain, 0));
  }

  @Test
  void chainOfTheWrongStructureIsReported() {
    assertEquals("chain.json: the chain must be a JSON object, it is [1, 2]", problem("[1, 2]"));
    assertEquals("chain.json: the chain needs \"filters\", an array of filters", problem("{}"));
    assertEquals(
        "chain.json: the chain has no \"filter\";"
            + " it may have \"filters\", \"name\", \"enabled\", \"comment\"",
        problem("{\"filter\": \"every-nth\"}"));
    assertEquals(
        "chain.json: filter 2 needs \"filter\", the name of a filter",
        problem("{\"filters\": [{\"filter\": \"every-nth\"}, {}]}"));
    assertEquals(
        "chain.json: filter 1, filter 1 must be a JSON object, it is 5",
        problem("{\"filters\": [{\"filters\": [5]}]}"));
    assertEquals(
        "chain.json: filter 1 has no \"on\";"
            + " it may have \"filter\", \"enabled\", \"settings\", \"comment\"",
        problem("{\"filters\": [{\"filter\": \"every-nth\", \"on\": true}]}"));
    assertEquals(
        "chain.json: filter 1: \"enabled\" is true or false, not 1",
        problem("{\"filters\": [{\"filter\": \"every-nth\", \"enabled\": 1}]}"));
    assertEquals(
        "chain.json: filter 1 (every-nth): its settings must be a JSON object, it is 3",
        problem("{\"filters\": [{\"filter\": \"every-nth\", \"settings\": 3}]}"));
  }

  @Test
  void fileIsReadAndNamedInProblems(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("my chain.json");
    Files.writeString(file, withSettings("\"n\": 3"));
    assertEquals(EveryNthFilter.Settings.of(3), settings(ChainFile.read(file, SENSOR), 0));
    Files.writeString(file, "{\n\"filters\": [\n");
    JsonProblem problem = assertThrows(JsonProblem.class, () -> ChainFile.read(file, SENSOR));
    assertTrue(problem.getMessage().startsWith(file + ", line 3, "), problem.getMessage());
  }

  private static String withSettings(String settings) {
    return "{\"filters\": [{\"filter\": \"every-nth\", \"settings\": {" + settings + "}}]}";
  }

  private static FilterChain parse(String text) throws IOException {
    return ChainFile.parse(text, "chain.json", SENSOR);
  }

  private static String problem(String text) {
    return assertThrows(JsonProblem.class, () -> parse(text)).getMessage();
  }

  private static Record settings(FilterChain chain, int stage) {
    return ((ConfigurableFilter<?>) chain.stages().get(stage).filter()).settings();
  }
}
