"""Compares Haltere with other programs that read and write the same formats, in one run on one machine.

./gradlew compareWithOthers [-Pformats=evt3,dat] [-Pruns=7] [-Pevents=20000000] [-PwithoutWriting]

Installs the other programs, pinned, into build/compare/python (each by itself; one that cannot be had is left out),
makes inputs in build/compare/inputs by repeating the recordings that HALTERE_RECORDINGS names, runs every program on
one core (taskset -c 0) and on all, and writes build/compare/comparison.md. Files are in the page cache; the figure is the
median of the runs, in million events a second. Ours are runs of a warm JVM: it reads or writes the file for five seconds
first. The first run of the others, in which some compile as well, is left out too. Needs Linux with taskset and a Python with venv; standard library only.
"""
import argparse
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

PACKAGES = {
    "faery": ["faery==0.7.1"],
    "evutils": ["evutils==0.3.18", "h5py==3.16.0", "hdf5plugin==7.1.0", "numba"],
    "expelliarmus": ["expelliarmus==1.1.12"],
    "evt3": ["evt3==0.4.1"],
    "event-stream": ["event-stream==1.6.3"],
    "aedat": ["aedat==2.3.0"],
    "dv-processing": ["dv-processing==2.0.4"],
    "dv-stores": ["dv-processing==2.0.4"],
    "eventcv": ["eventcv==1.0.8"],
    "tonic": ["tonic==1.7.0"],
}

# dv-stores: events of dv-processing that C++ can use, but that Python has not as arrays yet.
AEDAT4 = ["faery", "dv-processing", "dv-stores", "aedat", "eventcv"]

# Format: (how its input is made, programs that read it, what ours is to reach on one core and on two)
READING = {
    "aedat2-dvs128": (("bytes", "dvs128-pendulum.aedat", 70, ".aedat"), ["tonic"], 200, None),
    "aedat2-davis": (("repeat", "davis240c-rotating-disk-imu-aps.aedat", "aedat2", ".aedat"), ["eventcv"], 150, None),
    "aedat4-none": (("repeat", "dvxplorer-sample.aedat4", "aedat4-none", ".aedat4"), AEDAT4, 200, None),
    "aedat4-lz4": (("repeat", "dvxplorer-sample.aedat4", "aedat4-lz4", ".aedat4"), AEDAT4, 60, 115),
    "aedat4-zstd": (("repeat", "dvxplorer-sample.aedat4", "aedat4-zstd", ".aedat4"), AEDAT4, 48, 90),
    "evt2": (("repeat", "gen3-evt2.raw", "evt2", ".raw"), ["evutils", "faery", "expelliarmus", "eventcv"], 300, None),
    "evt21": (("bytes", "gen3-evt21-by-evutils.raw", 40, ".raw"), ["evutils"], 250, None),
    "evt3-dense": (("dense", None, "evt3", ".raw"), ["evutils", "evt3", "faery", "expelliarmus", "eventcv"], 200, None),
    "evt3-sparse": (("bytes", "imx636-evt3.raw", 20, ".raw"), ["evutils", "evt3", "faery", "expelliarmus", "eventcv"], 90, None),
    "dat": (("repeat", "gen4.dat", "dat", ".dat"), ["evutils", "expelliarmus", "faery", "eventcv"], 280, None),
    "es": (("repeat", "dvs.es", "es", ".es"), ["event-stream", "faery"], 80, None),
    "hdf5": (("other", "evutils", "davis346-by-evutils.h5", ".h5"), ["evutils"], 50, None),
    "csv": (("other", "evutils", "dvs.es", ".csv"), ["evutils", "faery"], 40, None),
    "rosbag": (("other", "eventcv", "davis346-by-evutils.h5", ".bag"), ["eventcv"], 90, None),
    "nmnist": (("bytes", "nmnist-sample.bin", 4600, ".bin"), ["tonic"], 90, None),
}

# Formats without a sensor size: ours searches all events for it unless it is stated, so it is measured both ways.
SENSORS = {"csv": "320x240", "nmnist": "34x34"}

# Format: (events that are written, ending, programs that write it, what ours is to reach)
WRITING = {
    "aedat4-none": ("dvxplorer-sample.aedat4", ".aedat4", ["dv-processing", "faery"], 152),
    "aedat4-lz4": ("dvxplorer-sample.aedat4", ".aedat4", ["dv-processing", "faery"], 28),
    "aedat4-zstd": ("dvxplorer-sample.aedat4", ".aedat4", ["dv-processing", "faery"], 17),
    "evt2": ("gen3-evt2.raw", ".raw", ["evutils", "faery", "eventcv"], 235),
    "evt3": ("imx636-evt3.raw", ".raw", ["evutils", "faery", "eventcv"], 66),
    "dat": ("gen4.dat", ".dat", ["evutils", "faery", "eventcv"], 244),
    "es": ("dvs.es", ".es", ["event-stream", "faery"], 75),
    "hdf5": ("davis346-by-evutils.h5", ".h5", ["evutils", "eventcv"], None),
}

COPIES = {
    "davis240c-rotating-disk-imu-aps.aedat": 374296,
    "dvxplorer-sample.aedat4": 111954,
    "gen3-evt2.raw": 521252,
    "imx636-evt3.raw": 1218618,
    "gen4.dat": 1218618,
    "dvs.es": 473225,
    "davis346-by-evutils.h5": 78830,
}
# The memory that a streaming read is given, so that the JVM does not take what it need not.
MEMORY = ["-Xmx64m", "-XX:+UseSerialGC"]


class Comparison:
    def __init__(self, options):
        self.options = options
        self.folder = Path(options.folder)
        self.inputs = self.folder / "inputs"
        self.inputs.mkdir(parents=True, exist_ok=True)
        self.python = self.folder / "python"
        self.recordings = Path(os.environ.get("HALTERE_RECORDINGS", "../shared/recordings"))
        self.tools = Path(__file__).with_name("tools.py")
        self.missing = {}
        self.notes = []

    def interpreter(self, program):
        """The Python that has a program; None if it cannot be had."""
        home = self.python / program
        ready = home / "ready"
        if program in self.missing:
            return None
        if not ready.exists():
            print("installing", program, flush=True)
            shutil.rmtree(home, ignore_errors=True)
            try:
                subprocess.run([sys.executable, "-m", "venv", home], check=True, timeout=60)
                subprocess.run(
                    [home / "bin/pip", "install", "-q", "--disable-pip-version-check", *PACKAGES[program]],
                    check=True,
                    timeout=self.options.install_seconds,
                )
                ready.touch()
            except (subprocess.SubprocessError, OSError) as reason:
                self.missing[program] = str(reason)
                self.notes.append(f"{program} could not be installed")
                return None
        return home / "bin/python"

    def run(self, command, cores):
        """Medians of a command's runs: million events a second, events, peak KiB; None if it failed."""
        prefix = ["taskset", "-c", "0"] if cores == 1 else []
        try:
            done = subprocess.run(
                [*prefix, *map(str, command)],
                capture_output=True,
                text=True,
                timeout=self.options.run_seconds,
            )
        except subprocess.TimeoutExpired:
            return "it took too long"
        lines = [line.split() for line in done.stdout.splitlines()]
        runs = [(int(line[1]), float(line[2])) for line in lines if line and line[0] == "run"]
        peaks = [int(line[1]) for line in lines if line and line[0] == "peak"]
        if done.returncode != 0 or not peaks:
            return (done.stderr.strip().splitlines() or ["it failed"])[-1][:120]
        measured = runs[len(runs) - self.options.runs :]
        rate = statistics.median(events / seconds / 1e6 for events, seconds in measured) if measured else 0
        return rate, measured[-1][0] if measured else 0, peaks[0]

    def ours(self, *arguments, memory=()):
        return ["java", *memory, "-cp", self.options.classpath, "haltere.testing.comparison.ComparedRuns", *arguments]

    def make(self, name, how):
        """An input of about as many events as asked for; None if its recording is missing."""
        kind, recording, parameter, ending = how
        target = self.inputs / (name + ending)
        if target.exists():
            return target
        share = self.options.events / 20_000_000
        print("making", target, flush=True)
        if kind == "dense":
            command = self.ours("dense", parameter, target, str(self.options.events))
        elif kind == "bytes":
            source = self.recordings / recording
            if not source.exists():
                return None
            data = source.read_bytes()
            start = 0
            while data[start : start + 2] == b"% " or data[start : start + 1] == b"#":
                start = data.index(b"\n", start) + 1
            with open(target, "wb") as out:
                out.write(data[:start])
                for _ in range(max(1, round(parameter * share))):
                    out.write(data[start:])
            return target
        elif kind == "other":
            events = self.events(parameter)
            program = self.interpreter(recording)
            if events is None or program is None:
                return None
            command = [program, self.tools, "make", recording, events, target]
        else:
            source = self.recordings / recording
            if not source.exists():
                return None
            copies = max(1, self.options.events // COPIES[recording])
            command = self.ours("repeat", source, parameter, target, str(copies))
        done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
        if done.returncode != 0:
            target.unlink(missing_ok=True)
            self.notes.append(f"{name}: no input: {(done.stderr.strip().splitlines() or ['?'])[-1][:150]}")
            return None
        return target

    def events(self, recording):
        """The events of a recording, repeated, as arrays."""
        copies = max(1, self.options.events // COPIES[recording])
        return self.make("events-of-" + recording.replace(".", "-"), ("repeat", recording, "npz", ".npz"))

    def others(self, programs, *arguments):
        """The results of other programs on one core, of those that can be had."""
        runs = str(self.options.runs + 1)
        commands = [(program, self.interpreter(program)) for program in programs]
        return [
            (program, self.run([python, self.tools, arguments[0], program, *arguments[1:], runs], 1))
            for program, python in commands
            if python is not None
        ]

    def row(self, name, ours, results, goals):
        """A row of the table: ours on one core and on all, the others, best first."""
        one, two = ours
        told = []
        good = [(program, result) for program, result in results if not isinstance(result, str)]
        for program, result in sorted(good, key=lambda pair: -pair[1][0]):
            note = "" if result[1] == one[1] else f" ({result[1]:,} events instead of {one[1]:,})"
            told.append(f"{program} {result[0]:.0f}{note}")
        told += [f"{program}: {result}" for program, result in results if isinstance(result, str)]
        best = max((result[0] for _, result in good), default=None)
        verdict = "" if best is None else "yes" if one[0] >= best else "no"
        goal = "" if goals[0] is None else f"{goals[0]}"
        goal += "" if goals[1] is None else f" / {goals[1]}"
        line = f"| {name} | {one[0]:.0f} | {two[0]:.0f} | {goal} | {verdict} | {', '.join(told)} |"
        print(line, flush=True)
        return line

    def reading(self):
        lines = ["| reading | ours, one core | all cores | goal | fastest on one core | others, one core |", "|---|---|---|---|---|---|"]
        memory = ["| reading | peak above an empty program, MiB |", "|---|---|"]
        idle = self.run(self.ours("idle", memory=MEMORY), 2)
        for name, (how, programs, one, two) in READING.items():
            if not self.wanted(name):
                continue
            file = self.make(name, how)
            if file is None:
                self.notes.append(f"{name}: left out, its recording or the program that writes it is missing")
                continue
            file.read_bytes()  # into the page cache
            others = self.others(programs, "read", name, file)
            for sensor in (None, SENSORS[name]) if name in SENSORS else (None,):
                stated = [] if sensor is None else [sensor]
                ours = [self.run(self.ours("read", file, str(self.options.runs), *stated), cores) for cores in (1, 2)]
                if any(isinstance(result, str) for result in ours):
                    self.notes.append(f"{name}: ours failed: {ours}")
                    continue
                label = name if sensor is None else name + ", size stated"
                lines.append(self.row(label, ours, others, (one, two)))
            small = self.run(self.ours("read", file, "2", memory=[*MEMORY, "-Dwarm=0"]), 2)
            told = small if isinstance(small, str) else f"{(small[2] - idle[2]) / 1024:.0f}"
            memory.append(f"| {name} | {told} |")
        return lines + [""] + memory

    def writing(self):
        lines = ["| writing | ours, one core | all cores | goal | fastest on one core | others, one core |", "|---|---|---|---|---|---|"]
        target = self.inputs / "written"
        for name, (recording, ending, programs, goal) in WRITING.items():
            if not self.wanted(name):
                continue
            events = self.events(recording)
            if events is None:
                continue
            file = target.with_suffix(ending)
            ours = [self.run(self.ours("write", events, name, file, str(self.options.runs)), cores) for cores in (1, 2)]
            if any(isinstance(result, str) for result in ours):
                self.notes.append(f"{name}: ours failed: {ours}")
                continue
            others = self.others(programs, "write", name, events, file)
            lines.append(self.row(name, ours, others, (goal, None)))
            file.unlink(missing_ok=True)
        return lines

    def wanted(self, name):
        formats = self.options.formats
        return not formats or any(name == wanted or name.startswith(wanted + "-") for wanted in formats)

    def report(self):
        version = subprocess.run(["java", "-version"], capture_output=True, text=True).stderr.splitlines()[0]
        lines = [
            "# Haltere beside other programs",
            "",
            f"Million events a second, median of {self.options.runs} runs, about {self.options.events:,} events a file,"
            f" files in the page cache, {os.cpu_count()} cores, {version}.",
            "Ours in a warm JVM. Recordings repeated; `evt3-dense` is synthetic.",
            "",
        ]
        if not self.options.only_writing:
            lines += self.reading() + [""]
        if not self.options.without_writing:
            lines += self.writing() + [""]
        lines += [f"- {note}" for note in dict.fromkeys(self.notes)]
        path = self.folder / "comparison.md"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        print("written to", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--classpath", required=True)
    parser.add_argument("--folder", default="build/compare")
    parser.add_argument("--formats", type=lambda text: [part for part in text.split(",") if part], default=[])
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--events", type=int, default=20_000_000)
    parser.add_argument("--install-seconds", type=int, default=180)
    parser.add_argument("--run-seconds", type=int, default=300)
    parser.add_argument("--without-writing", action="store_true")
    parser.add_argument("--only-writing", action="store_true")
    Comparison(parser.parse_args()).report()


if __name__ == "__main__":
    main()
