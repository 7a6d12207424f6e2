package haltere.core.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class CamerasTest {
  private final List<String> opened = new ArrayList<>();

  private final Cameras cameras =
      new Cameras(
          List.of(
              new Shelf(false, info("simulated:fly", true, "a scene")),
              new Shelf(
                  true, info("dvs128:1", false, "another program has it"), info("b:2", true, ""))));

  @Test
  void physicalCamerasComeFirst() {
    assertEquals(
        List.of("dvs128:1", "b:2", "simulated:fly"),
        cameras.list().stream().map(CameraInfo::id).toList());
  }

  @Test
  void unnamedCameraIsTheFirstPhysicalOneThatCanBeOpened() throws CameraProblem {
    cameras.open("", CameraOptions.DEFAULT);

    assertEquals(List.of("b:2"), opened);
  }

  @Test
  void cameraIsOpenedByItsName() throws CameraProblem {
    cameras.open("simulated:fly", CameraOptions.DEFAULT);

    assertEquals(List.of("simulated:fly"), opened);
  }

  @Test
  void unknownCamerasAreRejectedWithTheListOfCameras() {
    CameraProblem problem =
        assertThrows(CameraProblem.class, () -> cameras.open("b:3", CameraOptions.DEFAULT));

    assertEquals(CameraProblem.Kind.NOT_FOUND, problem.kind());
    assertEquals(
        "there is no camera b:3; there are dvs128:1 (another program has it), b:2, simulated:fly",
        problem.getMessage());
  }

  @Test
  void absenceOfCamerasIsReported() {
    CameraProblem problem =
        assertThrows(
            CameraProblem.class, () -> new Cameras(List.of()).open("", CameraOptions.DEFAULT));

    assertEquals(
        "no camera is connected; no driver is found; those of USB cameras are in haltere-device",
        problem.getMessage());
  }

  @Test
  void camerasThatAreOnlyOpenedByNameAreReported() {
    Cameras simulated = new Cameras(List.of(new Shelf(false, info("simulated:fly", true, ""))));

    assertEquals(
        "no camera is connected; others are opened by name: simulated:fly", refusal(simulated));
  }

  @Test
  void connectedCamerasThatCannotBeOpenedAreReportedWithTheReason() {
    Cameras busy =
        new Cameras(
            List.of(
                new Shelf(true, info("dvs128:1", false, "another program has it")),
                new Shelf(false, info("simulated:fly", true, ""))));

    assertEquals(
        "no connected camera can be opened: dvs128:1 (another program has it); others are opened"
            + " by name: simulated:fly",
        refusal(busy));
  }

  private static String refusal(Cameras cameras) {
    return assertThrows(CameraProblem.class, () -> cameras.open("", CameraOptions.DEFAULT))
        .getMessage();
  }

  @Test
  void providersReportWhyTheyFindNoCamera() {
    CameraProvider blind =
        new CameraProvider() {
          @Override
          public String name() {
            return "usb";
          }

          @Override
          public List<CameraInfo> list() {
            return List.of();
          }

          @Override
          public Optional<String> obstacle() {
            return Optional.of("there is no libusb");
          }

          @Override
          public Camera open(CameraInfo info, CameraOptions options) throws CameraProblem {
            throw new CameraProblem(CameraProblem.Kind.NOT_FOUND, "there is none");
          }
        };
    Cameras none = new Cameras(List.of(blind));

    assertEquals(List.of("usb: there is no libusb"), none.obstacles());
    CameraProblem problem =
        assertThrows(CameraProblem.class, () -> none.open("", CameraOptions.DEFAULT));
    assertTrue(problem.getMessage().endsWith("; usb: there is no libusb"), problem.getMessage());
  }

  @Test
  void everyProviderThatReportsChangesNotifiesASubscriber() {
    List<Runnable> watching = new ArrayList<>();
    int[] told = {0};
    CameraProvider.Watch watch =
        new Cameras(List.of(new Shelf(true), new TellingShelf(watching))).watch(() -> told[0]++);

    watching.forEach(Runnable::run);
    assertEquals(1, told[0]);
    watch.close();
    assertEquals(List.of(), watching);
  }

  private final class TellingShelf extends Shelf {
    private final List<Runnable> watching;

    TellingShelf(List<Runnable> watching) {
      super(true);
      this.watching = watching;
    }

    @Override
    public Optional<Watch> watch(Runnable changed) {
      watching.add(changed);
      return Optional.of(() -> watching.remove(changed));
    }
  }

  @Test
  void timesOfOneCameraAreMappedToTheClockOfAnother() {
    ClockRelation one = new ClockRelation(1_000_000, 50_000_000_000L);
    ClockRelation other = new ClockRelation(0, 50_000_300_000L);

    assertEquals(200, one.onClockOf(other, 1_000_500));
    assertEquals(1_000_500, other.onClockOf(one, 200));
  }

  private static CameraInfo info(String id, boolean canOpen, String note) {
    return new CameraInfo(id, "Model", "", new SensorGeometry(4, 4), canOpen, note);
  }

  private class Shelf implements CameraProvider {
    private final boolean physical;
    private final List<CameraInfo> infos;

    Shelf(boolean physical, CameraInfo... infos) {
      this.physical = physical;
      this.infos = List.of(infos);
    }

    @Override
    public String name() {
      return "shelf";
    }

    @Override
    public boolean isPhysical() {
      return physical;
    }

    @Override
    public List<CameraInfo> list() {
      return infos;
    }

    @Override
    public Camera open(CameraInfo info, CameraOptions options) {
      opened.add(info.id());
      return null;
    }
  }
}
