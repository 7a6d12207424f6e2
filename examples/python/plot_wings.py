#!/usr/bin/env python3
"""Plots a table of `haltere wings`: stroke angle, amplitude and frequency of both wings over time.

Usage:
    plot_wings.py WINGS.csv|WINGS.parquet PICTURE.png [--from S] [--to S]

Requires matplotlib, and pyarrow for Parquet. The cells (# %%) run one by one in Jupyter, Spyder and VS Code.
"""

# %% Read the table
import argparse
import csv
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("wings")
parser.add_argument("picture")
parser.add_argument("--from", dest="start", type=float, default=0, help="seconds after the first row")
parser.add_argument("--to", dest="end", type=float, default=float("inf"), help="seconds after the first row")
options = parser.parse_args()

try:
    with open(options.wings, "rb") as file:
        if options.wings.endswith(".parquet"):
            import pyarrow.parquet

            rows = pyarrow.parquet.read_table(file).to_pylist()
        else:
            rows = list(csv.DictReader(io.TextIOWrapper(file, encoding="utf-8", newline="")))
except (OSError, ValueError) as problem:
    parser.exit(1, f"{options.wings} cannot be read: {problem}\n")
if not rows or not {"t_us", "edge", "angle_rad", "amplitude_rad", "frequency_hz"} <= rows[0].keys():
    parser.error(f"{options.wings} is no table of `haltere wings`, or has no rows")
first_us = min(int(row["t_us"]) for row in rows)

# %% Rows of each wing in the selected time range
wings = {"left": [], "right": []}
for row in rows:
    seconds = (int(row["t_us"]) - first_us) * 1e-6
    if row["edge"] in wings and options.start <= seconds <= options.end:
        wings[row["edge"]].append((seconds, row))

# %% Plot: an empty field (null) is unknown and leaves a gap
panels = [("angle_rad", "stroke angle (rad)"), ("amplitude_rad", "amplitude (rad)"), ("frequency_hz", "frequency (Hz)")]
figure, axes = plt.subplots(len(panels), 1, sharex=True, figsize=(10, 7), layout="constrained")
for axis, (column, label) in zip(axes, panels):
    for side, points in wings.items():
        values = [float("nan") if row[column] in ("", None) else float(row[column]) for _, row in points]
        axis.plot([seconds for seconds, _ in points], values, label=side, linewidth=0.8)
    axis.set_ylabel(label)
    axis.grid(alpha=0.3)
axes[0].legend(loc="upper right")
axes[-1].set_xlabel("time after the first row (s)")
try:
    figure.savefig(options.picture, dpi=120)
except (OSError, ValueError) as problem:
    parser.exit(1, f"{options.picture} cannot be written: {problem}\n")
print(f"wrote {options.picture}: {sum(len(points) for points in wings.values())} rows")
