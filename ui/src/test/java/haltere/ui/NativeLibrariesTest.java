package haltere.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NativeLibrariesTest {
  @Test
  void completeLibrariesGiveNoMessage() {
    assertEquals(Optional.empty(), NativeLibraries.complaint(file -> true));
  }

  @Test
  void missingLibrariesAreReportedWithPackagesInOneLine() {
    String line = NativeLibraries.complaint(file -> false).orElseThrow();
    assertTrue(line.contains("libgtk-3-0 libgl1 libxtst6"), line);
    assertTrue(line.contains("libgtk-3.so.0"), line);
    assertFalse(line.contains("\n"), line);
  }

  @Test
  void onlyMissingLibrariesAreReported() {
    String line = NativeLibraries.complaint(file -> !file.equals("libXtst.so.6")).orElseThrow();
    assertTrue(line.contains("(libXtst.so.6): install the packages libxtst6 "), line);
  }

  @Test
  void unknownLibraryIsNotFound() {
    assertFalse(NativeLibraries.present("libhaltere-no-such-library.so.7"));
  }

  @Test
  void linkerCacheEntriesCountOnlyIfTheirFilesExist(@TempDir Path folder) throws IOException {
    Path library = Files.createFile(folder.resolve("libreal.so.1"));
    String list =
        "2 libs found in cache\n"
            + "\tlibreal.so.1 (libc6,x86-64) => "
            + library
            + "\n\tlibgone.so.1 (libc6,x86-64) => /nowhere/libgone.so.1\n";
    assertTrue(NativeLibraries.isListed("libreal.so.1", list));
    assertFalse(NativeLibraries.isListed("libgone.so.1", list));
    assertFalse(NativeLibraries.isListed("libreal.so", list));
  }
}
