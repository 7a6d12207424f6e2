package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.ArrayList;
import java.util.List;

/**
 * Draws the groups of vehicles of one direction. The first vehicle of a group enters at time 0 of
 * the group, none before it.
 *
 * <p>Thread rule: immutable; the random numbers are the caller's.
 */
final class Encounters {
  private static final double BRAKE = 4;
  private static final double START = 2.5;
  private static final double LANE_CHANGE_S = 1.5;
  private static final double MARGIN_M = 1;

  private final TrafficSettings traffic;
  private final VehicleSettings vehicles;
  private final boolean away;
  private final int lanes;

  Encounters(TrafficSettings traffic, VehicleSettings vehicles, boolean away) {
    this.traffic = traffic;
    this.vehicles = vehicles;
    this.away = away;
    lanes = away ? traffic.lanesAway() : traffic.lanesTowards();
  }

  int lanes() {
    return lanes;
  }

  /** Vehicles of one encounter that do not collide. */
  List<Vehicle> draw(SeededRandom random) {
    EncounterSettings weights = traffic.encounters();
    double[] shares = {
      weights.overtake(),
      weights.sideBySide(),
      weights.stop(),
      weights.speedChange(),
      weights.cruise()
    };
    double sum = 0;
    for (double share : shares) {
      sum += share;
    }
    double place = random.nextDouble() * sum;
    int which = 0;
    while (which < 4 && (sum == 0 || place >= shares[which])) {
      place -= shares[which++];
    }
    List<Vehicle> drawn =
        switch (which) {
          case 0 -> lanes > 1 ? overtake(random) : cruise(random);
          case 1 -> lanes > 1 ? sideBySide(random) : cruise(random);
          case 2 -> stop(random);
          case 3 -> speedChange(random);
          default -> cruise(random);
        };
    if (drawn.size() == 2 && !drawn.get(0).avoids(drawn.get(1))) {
      return drawn.subList(0, 1);
    }
    return drawn;
  }

  /** Centre of a lane; 0 is the slowest one at the side of the road. */
  private double laneM(int lane) {
    double fromMiddle = (lanes - lane - 0.5) * traffic.laneWidthM();
    return away ? fromMiddle : -fromMiddle;
  }

  private double inLane(int lane, SeededRandom random) {
    return laneM(lane) + random.between(-0.05, 0.05) * traffic.laneWidthM();
  }

  private VehicleKind kind(SeededRandom random) {
    double sum = vehicles.cars() + vehicles.lorries() + vehicles.motorcycles();
    double place = random.nextDouble() * sum;
    if (sum == 0 || place < vehicles.cars()) {
      return VehicleKind.CAR;
    }
    return place < vehicles.cars() + vehicles.lorries()
        ? VehicleKind.LORRY
        : VehicleKind.MOTORCYCLE;
  }

  private Bodywork body(VehicleKind kind, SeededRandom random) {
    return Bodywork.draw(kind, away, vehicles, random);
  }

  private double speed(double share, SeededRandom random) {
    double spread = Math.max(0.5, 1 + traffic.speedSpread() * random.gaussian());
    return traffic.speedMS() * share * spread;
  }

  private static double usual(VehicleKind kind, int lane) {
    return (kind == VehicleKind.LORRY ? 0.85 : 1) * (1 + 0.15 * lane);
  }

  private Vehicle vehicle(Bodywork body, double enterS, Drive drive, Steering steering) {
    return new Vehicle(0, body, away, enterS, drive, steering, traffic.roadM());
  }

  private List<Vehicle> cruise(SeededRandom random) {
    int count = 1 + random.below(2);
    List<Vehicle> group = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      VehicleKind kind = kind(random);
      int lane = random.below(lanes);
      Drive drive = Drive.steady(speed(usual(kind, lane), random));
      group.add(
          vehicle(
              body(kind, random),
              i * random.between(0.2, 2),
              drive,
              Steering.straight(inLane(lane, random))));
    }
    return group;
  }

  /** A slow one in the lane at the side; a fast one from behind it, by the next lane, and back. */
  private List<Vehicle> overtake(SeededRandom random) {
    int lane = random.below(lanes - 1);
    Bodywork slow = body(random.below(2) == 0 ? VehicleKind.LORRY : kind(random), random);
    Bodywork fast = body(random.below(4) == 0 ? VehicleKind.MOTORCYCLE : VehicleKind.CAR, random);
    double slowSpeed = speed(0.45, random);
    double fastSpeed = slowSpeed * random.between(1.9, 2.3);
    double relative = fastSpeed - slowSpeed;
    // distances are those of fronts; the centre is half a length behind
    double passM = random.between(0.4, 0.55) * traffic.roadM();
    double lengths = (slow.lengthM() + fast.lengthM()) / 2;
    double passS = passM / slowSpeed;
    double fastM = passM + (fast.lengthM() - slow.lengthM()) / 2;
    double fastEnterS = passS - fastM / fastSpeed;
    double needS = (lengths + Vehicle.distance(slowSpeed) + MARGIN_M) / relative;
    double laneChange = laneM(lane + 1) - laneM(lane);
    double fastPassS = passS - fastEnterS;
    Steering steering =
        new Steering(
            inLane(lane, random),
            laneChange,
            fastPassS - needS - LANE_CHANGE_S,
            fastPassS + needS,
            LANE_CHANGE_S);
    return List.of(
        vehicle(slow, 0, Drive.steady(slowSpeed), Steering.straight(inLane(lane, random))),
        vehicle(fast, fastEnterS, Drive.steady(fastSpeed), steering));
  }

  private List<Vehicle> sideBySide(SeededRandom random) {
    int lane = random.below(lanes - 1);
    Bodywork lorry = body(VehicleKind.LORRY, random);
    Bodywork motorcycle = body(VehicleKind.MOTORCYCLE, random);
    double speed = speed(0.85, random);
    double other = speed * random.between(1, 1.04);
    return List.of(
        vehicle(lorry, 0, Drive.steady(speed), Steering.straight(inLane(lane, random))),
        vehicle(
            motorcycle,
            random.between(0.1, 0.4) * lorry.lengthM() / speed,
            Drive.steady(other),
            Steering.straight(inLane(lane + 1, random))));
  }

  private Drive stopAt(double speed, double wayM, double startS) {
    double brakeS = speed / BRAKE;
    double fromS = (wayM - speed * brakeS / 2) / speed;
    double stoppedS = fromS + brakeS;
    double goS = Math.max(startS, stoppedS + 0.2);
    return Drive.steady(speed).then(fromS, stoppedS, -BRAKE).then(goS, goS + speed / START, START);
  }

  private List<Vehicle> stop(SeededRandom random) {
    int lane = random.below(lanes);
    Bodywork first = body(kind(random), random);
    Bodywork second = body(kind(random), random);
    double speed = speed(0.8, random);
    double brakeM = speed * speed / BRAKE / 2;
    double stopM = Math.max(brakeM, random.between(0.15, 0.45) * traffic.roadM()) + 1;
    double stoppedS = stopM / speed + speed / BRAKE / 2;
    double goS = stoppedS + traffic.encounters().stopS();
    Vehicle leader =
        vehicle(first, 0, stopAt(speed, stopM, goS), Steering.straight(inLane(lane, random)));
    if (random.below(2) == 0) {
      return List.of(leader);
    }
    // distances are those of fronts, so the length of the first vehicle counts
    double behindM = first.lengthM() + Vehicle.distance(0) + MARGIN_M;
    double enterS = random.between(1, 2) + behindM / speed;
    Vehicle follower =
        vehicle(
            second,
            enterS,
            stopAt(speed, Math.max(stopM - behindM, brakeM), goS + 0.9 - enterS),
            Steering.straight(inLane(lane, random)));
    return List.of(leader, follower);
  }

  private List<Vehicle> speedChange(SeededRandom random) {
    int lane = random.below(lanes);
    VehicleKind kind = kind(random);
    double speed = speed(usual(kind, lane), random);
    double change = random.between(0.25, 0.5) * speed;
    double slowdown = random.between(2, 4);
    double fromS = random.between(0.1, 0.4) * traffic.roadM() / speed;
    double slowS = fromS + change / slowdown;
    double againS = slowS + random.between(0.2, 1.5);
    Drive drive =
        Drive.steady(speed)
            .then(fromS, slowS, -slowdown)
            .then(againS, againS + change / START, START);
    return List.of(vehicle(body(kind, random), 0, drive, Steering.straight(inLane(lane, random))));
  }
}
