// Tracks the objects of a recording: ImageJ -batch track.ijm RECORDING
setBatchMode(true);
run("Event camera recording...", "recording=[" + getArgument() + "] slice=10 show=Signed");
run("Track objects...", "rate=100");
Table.save(getArgument() + ".objects.csv");
