package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RecentPlacesTest {
  private final RecentPlaces places = new RecentPlaces(2);

  @Test
  void aPlaceIsFoundWithinItsRadiusUntilItsTime() {
    int place = places.add(10, 20, 5, 1_000, 3_000);
    assertEquals(place, places.find(13, 23, 2_999));
    assertEquals(RecentPlaces.NONE, places.find(15, 20, 2_000), "at its border");
    assertEquals(RecentPlaces.NONE, places.find(10, 20, 3_000), "too late");
    assertEquals(RecentPlaces.NONE, places.find(10, 20, 999), "before it was seen");
  }

  @Test
  void aPlaceThatIsSeenAgainIsRememberedForLonger() {
    int place = places.add(10, 20, 5, 1_000, 3_000);
    places.see(place, 2_500, 5_000);
    places.resize(place, 9);
    assertEquals(place, places.find(18, 20, 4_999));
  }

  @Test
  void whatIsForgottenIsNotFound() {
    places.forget(places.add(10, 20, 5, 1_000, 3_000));
    assertEquals(RecentPlaces.NONE, places.find(10, 20, 2_000));
    places.add(10, 20, 5, 1_000, 3_000);
    places.clear();
    assertEquals(RecentPlaces.NONE, places.find(10, 20, 2_000));
  }

  @Test
  void ofTooManyTheOldestIsForgotten() {
    places.add(10, 20, 5, 1_000, 9_000);
    int second = places.add(50, 20, 5, 2_000, 9_000);
    int third = places.add(90, 20, 5, 3_000, 9_000);
    assertEquals(RecentPlaces.NONE, places.find(10, 20, 4_000));
    assertEquals(second, places.find(50, 20, 4_000));
    assertEquals(third, places.find(90, 20, 4_000));
  }
}
