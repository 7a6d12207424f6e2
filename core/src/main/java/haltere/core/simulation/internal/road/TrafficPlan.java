package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.ArrayList;
import java.util.List;

/**
 * All vehicles of a road, past and future. The time of each direction is divided into long blocks.
 * The vehicles of a block are drawn from the seed and the number of the block alone, and all leave
 * before the next one begins. So they can be queried for any time, in any order, and only a few
 * blocks are held. Within a block a group enters as soon as its pause is over and its vehicles keep
 * their distance from all earlier ones. The two directions change their blocks at different times,
 * so that the road is never empty.
 *
 * <p>Thread rule: any thread.
 */
final class TrafficPlan {
  private static final int DIRECTIONS = 2;
  private static final int MAX_IN_BLOCK = 10_000;
  private static final double MIN_BLOCK_S = 120;
  private static final double TRY_EACH_S = 0.25;

  private record Block(long number, List<Vehicle> vehicles) {}

  private final RoadSceneSettings settings;
  private final double blockS;
  private final Encounters[] encounters = new Encounters[DIRECTIONS];
  private final Block[] recent = new Block[DIRECTIONS];

  TrafficPlan(RoadSceneSettings settings) {
    this.settings = settings;
    TrafficSettings traffic = settings.traffic();
    // a slow vehicle is there for about two times the road's length over the speed
    double longestS = 3 * traffic.roadM() / traffic.speedMS() + traffic.encounters().stopS();
    blockS = Math.max(MIN_BLOCK_S, 8 * longestS);
    for (int direction = 0; direction < DIRECTIONS; direction++) {
      encounters[direction] = new Encounters(traffic, settings.vehicles(), direction == 0);
    }
  }

  /** Adds the vehicles that are on the road at a time, seconds since the beginning. */
  void collect(double seconds, List<Vehicle> out) {
    for (int direction = 0; direction < DIRECTIONS; direction++) {
      if (encounters[direction].lanes() == 0) {
        continue;
      }
      // the scene begins in the middle of one block and at three quarters of the other
      double offsetS = blockS * (0.5 - 0.25 * direction);
      List<Vehicle> vehicles =
          block(direction, (long) Math.floor((seconds + offsetS) / blockS), offsetS);
      for (int i = 0; i < vehicles.size(); i++) {
        Vehicle vehicle = vehicles.get(i);
        if (vehicle.isThere(seconds)) {
          out.add(vehicle);
        }
      }
    }
  }

  private List<Vehicle> block(int direction, long number, double offsetS) {
    synchronized (recent) {
      Block block = recent[direction];
      if (block == null || block.number != number) {
        block = new Block(number, draw(direction, number, number * blockS - offsetS));
        recent[direction] = block;
      }
      return block.vehicles;
    }
  }

  private List<Vehicle> draw(int direction, long number, double fromS) {
    SeededRandom random = SeededRandom.of(settings.run().seed(), "traffic " + direction, number);
    double pauseS = settings.traffic().pauseS();
    List<Vehicle> all = new ArrayList<>();
    double startS = fromS;
    while (true) {
      startS += Math.min(20, random.exponential()) * pauseS;
      List<Vehicle> group = encounters[direction].draw(random);
      while (!isClear(group, startS, all)) {
        startS += TRY_EACH_S;
      }
      for (Vehicle vehicle : group) {
        long place = DIRECTIONS * MAX_IN_BLOCK * (number + 1) + direction;
        Vehicle placed = vehicle.later(startS, (int) (place + DIRECTIONS * (long) all.size()));
        if (placed.leaveS >= fromS + blockS) {
          return List.copyOf(all);
        }
        all.add(placed);
      }
    }
  }

  private static boolean isClear(List<Vehicle> group, double startS, List<Vehicle> all) {
    for (Vehicle vehicle : group) {
      Vehicle placed = vehicle.later(startS, 0);
      for (int i = all.size() - 1; i >= 0; i--) {
        Vehicle other = all.get(i);
        if (other.leaveS > placed.enterS && !placed.avoids(other)) {
          return false;
        }
      }
    }
    return true;
  }
}
