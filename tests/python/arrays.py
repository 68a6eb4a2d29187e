"""arrays.py CASE RECORD: every array that Python gives of a case and of a record in g, as JSON, by NumPy and bentur alone."""

import json
import sys

import numpy as np

import bentur


def plain(value):
    """Arrays as lists: what is read one by one from where the array says that its elements are."""
    if isinstance(value, dict):
        return {name: plain(one) for name, one in value.items()}
    if isinstance(value, list):
        return [plain(one) for one in value]
    return value.tolist() if isinstance(value, np.ndarray) else value


def main(case, record):
    result = bentur.run(case)
    read = bentur.read_record(record)
    spectrum = bentur.response_spectrum(record, damping=0.02, unit="g", length="cm")
    json.dump(plain({
        "numpy": np.__version__,
        "summary": result.summary,
        "impacts": result.impact_arrays,
        "histories": result.histories,
        "exact": result.exact,
        "modes": bentur.modes(case),
        "record": {"time": read.time, "values": read.values},
        "spectrum": vars(spectrum),
    }), sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
