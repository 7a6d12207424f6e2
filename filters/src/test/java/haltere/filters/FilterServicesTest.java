package haltere.filters;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.filters.noise.RefractoryFilter;
import haltere.testing.ServiceFiles;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class FilterServicesTest {
  @Test
  void serviceFileAndProvidersMatch() {
    assertEquals(
        ServiceFiles.implementations(FilterProvider.class, RefractoryFilter.class),
        ServiceFiles.registered(FilterProvider.class));
  }

  @Test
  void everyProviderIsFoundByName() {
    Set<String> found =
        Filters.all().values().stream()
            .map(provider -> provider.getClass().getName())
            .collect(Collectors.toCollection(TreeSet::new));
    assertEquals(ServiceFiles.registered(FilterProvider.class), found);
  }

  @Test
  void namesAreHyphenatedWordsAndDescriptionsAreSentences() {
    Filters.all()
        .forEach(
            (name, provider) -> {
              assertEquals(name, provider.name());
              assertTrue(name.matches("[a-z0-9]+(-[a-z0-9]+)*"), name);
              assertTrue(provider.description().endsWith("."), provider.description());
            });
  }
}
