"""Many runs: sweeps, incremental dynamic analyses, fragilities."""

from __future__ import annotations

import json
import os
import re
import tempfile
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import astuple, replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._case import Case
from ._dataset import dataset, import_xarray
from ._errors import CaseError, Finding
from ._functions import Progress, shown

if TYPE_CHECKING:
    import xarray

_TOGETHER = 16  # runs given to a thread at a time: enough for runs of one group to share their work


def sweep(
    study: str | PathLike[str], *, threads: int | None = None, progress: Progress = None
) -> xarray.Dataset:
    """Runs a study file (docs/studies.md), as ``bentur sweep`` does and with the same numbers, into a Dataset with the
    names, dimensions and units of its file of results. Everything is kept in memory; a study that is to be resumed,
    or to run on a cluster, is for the command.

    :param threads: default: one per processor. Ctrl-C stops them all.
    :raises CaseError: with all that is wrong in study, case and records.
    :raises ImportError: without xarray.
    """
    found: xarray.Dataset = _run(study, False, threads, progress)
    return found


def ida(study: str | PathLike[str], *, threads: int | None = None, progress: Progress = None) -> xarray.Dataset:
    """An incremental dynamic analysis: a study with ``[ida]``, as ``bentur ida`` runs it. See :func:`sweep`."""
    found: xarray.Dataset = _run(study, True, threads, progress)
    return found


def _run(study: str | PathLike[str], is_ida: bool, threads: int | None, progress: Progress) -> Any:
    xarray = import_xarray("a study")
    if threads is not None:
        threads = _arguments.whole("threads", threads, 1, 4096)
    core = _core.Study(_arguments.path("study", study))
    if core.is_ida != is_ida:
        message = (
            "[ida] makes this an incremental dynamic analysis: use bentur.ida"
            if core.is_ida
            else "[ida] is missing, with intensity and levels; without it use bentur.sweep"
        )
        raise CaseError([(os.fspath(study), 0, 0, message)])
    with shown(progress, core.title or "runs") as show:
        _solve(core, threads, show)
    return dataset(xarray, *core.variables())


def _solve(core: _core.Study, threads: int | None, show: Callable[[float], object] | None) -> None:
    runs = core.runs
    done = 0
    # Work is handed out piece by piece, so that no more than some results wait at a time and Ctrl-C is heard at once.
    starts = iter(range(0, runs, _TOGETHER))
    workers = threads or len(os.sched_getaffinity(0))
    with ThreadPoolExecutor(workers) as pool:
        at_work: set[Future[int]] = set()
        try:
            while True:
                for start in starts:
                    at_work.add(pool.submit(core.solve, start, min(_TOGETHER, runs - start)))
                    if len(at_work) >= 2 * workers:
                        break
                if not at_work:
                    break
                ended, at_work = wait(at_work, return_when=FIRST_COMPLETED)
                done += sum(one.result() for one in ended)
                if show is not None:
                    show(done / runs)
        except BaseException:
            core.stop()
            raise


def vary(
    case: Case,
    values: Mapping[str, Sequence[Any] | NDArray[Any]],
    *,
    labels: Mapping[str, Sequence[str]] | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> xarray.Dataset:
    """A sweep made in Python: the full grid of all values, by the keys of the case.

    ``bentur.vary(case, {"gap[0].width": [0.0, 0.01, 0.02], "excitation.pga": [2.0, 4.0]})``

    Files are relative to the folder of the case, as in the case itself.

    :param labels: what the results call values that are no numbers, by the same keys; default texts themselves.
    :returns: as :func:`sweep`.
    """
    if case._laws:
        raise ValueError("a case with a law of Python's own cannot be varied: run it value by value")
    with tempfile.TemporaryDirectory(prefix="bentur-") as folder:
        tables = case.to_dict()
        tables = _placed("", tables, case.folder)
        (Path(folder) / "case.toml").write_text(_toml(tables), encoding="utf-8")
        study: dict[str, Any] = {"case": "case.toml", "vary": []}
        for key, given in values.items():
            levels = np.asarray(given).tolist() if not isinstance(given, list) else given
            one: dict[str, Any] = {"parameter": key, "values": [_placed(key, level, case.folder) for level in levels]}
            if labels and key in labels:
                one["labels"] = list(labels[key])
            elif levels and all(isinstance(level, str | PathLike) for level in levels):
                one["labels"] = [os.fspath(level) for level in levels]
            study["vary"].append(one)
        file = Path(folder) / "study.toml"
        file.write_text(_toml(study), encoding="utf-8")
        try:
            return sweep(file, threads=threads, progress=progress)
        except CaseError as error:
            raise CaseError(_as_given(one, list(values), folder) for one in error.errors) from None


def _as_given(found: Finding, keys: Sequence[str], folder: str) -> tuple[str, int, int, str, str, str, str, str]:
    """An error of a study that Python has written, without the place in a file that nobody has seen."""

    def given(text: str) -> str:
        return re.sub(
            r"\bvary\[(\d+)\]\.(\w+)",
            lambda at: f'{"labels" if at[2] == "labels" else "values"}["{keys[int(at[1])]}"]',
            text.replace(folder + os.sep, ""),
        )

    if Path(folder) in Path(found.file).parents:
        found = replace(found, file="", line=0, column=0, message=given(found.message), key=given(found.key))
    return astuple(found)


def _placed(key: str, value: Any, folder: Path) -> Any:
    """What stands at a key of the case, with the whole way to every file that it names."""
    if isinstance(value, Mapping):
        return {name: _placed(str(name), inner, folder) for name, inner in value.items()}
    if isinstance(value, list | tuple):
        return [_placed(key, inner, folder) for inner in value]
    if isinstance(value, PathLike) or (isinstance(value, str) and key.rpartition(".")[2] in ("file", "shapes_file")):
        return str((folder / value).resolve())
    return value


def _toml(table: Mapping[str, Any]) -> str:
    return "".join(f"{_toml_value(str(key))} = {_toml_value(value)}\n" for key, value in table.items())


def _toml_value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_toml_value(str(k))} = {_toml_value(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(map(_toml_value, value)) + "]"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    return repr(value)


def fragility(
    results: xarray.Dataset,
    event: str = "impacts > 0",
    *,
    at: float | None = None,
    probabilities: Sequence[float] = (),
    along: str = "",
    resamples: int = 1000,
    confidence: float = 0.95,
    seed: int = 1,
) -> dict[str, Any]:
    """Fragility curves, and the gap for a pounding probability, as ``bentur fragility --json`` has them.

    :param results: of :func:`ida`, or of ``bentur ida`` by ``xarray.open_dataset``.
    :param event: ``"QUANTITY > NUMBER"`` (also >= < <=) in the units of the results; true of a run where any point,
        floor or gap has it.
    :param at: intensity for the gaps, in the unit of the levels; goes with `probabilities`, each in (0, 1).
    :param along: the gap width that is meant, where several vary.
    :raises ValueError: where the results do not have what is asked for.
    """
    wanted = _arguments.listed("probabilities", probabilities)
    if not hasattr(results, "data_vars"):
        raise TypeError(f"results is a {type(results).__name__}, must be an xarray.Dataset of bentur.ida")
    if (at is None) != (len(wanted) == 0):
        raise ValueError("at and probabilities go together")
    if not all(0 < p < 1 for p in wanted):
        raise ValueError("probabilities must be in (0, 1)")
    told = _outcomes(results, _arguments.text("event", event))
    asked = {
        "resamples": _arguments.whole("resamples", resamples, 0, 10**6),
        "confidence": _arguments.number("confidence", confidence),
        "seed": _arguments.whole("seed", seed, 0, 2**64 - 1),
        "at": None if at is None else _arguments.number("at", at),
        "probabilities": wanted,
        "along": _arguments.text("along", along),
    }
    found: dict[str, Any] = json.loads(_core.fragility_json(told, event, asked))
    return found


def _outcomes(results: Any, event: str) -> dict[str, Any]:
    """Whether each run has the event: cases × records × levels, as the command finds them in its file of results."""
    quantity, comparison, threshold = _core.parse_event(event)
    for name in ("intensity", "record_intensity", "status"):
        if name not in results.variables:
            raise ValueError("these are not the results of an incremental dynamic analysis")
    status = results["status"]
    dims = list(status.dims)
    level = results["intensity"].dims[0]
    record_dims = [d for d in dims if d in results["record_intensity"].dims]
    other = [d for d in dims if d not in record_dims and d != level]
    wanted = "peak_drift_ratio" if quantity == "drift" else quantity
    names = [n for n in results.data_vars if list(results[n].dims[: len(dims)]) == dims and n not in ("status", "message")]
    chosen = [n for n in names if wanted in (n, _without_number(n))]
    compare = {">": np.greater, ">=": np.greater_equal, "<": np.less, "<=": np.less_equal}[comparison]
    if wanted == "impacts" and compare(1, threshold) and not compare(0, threshold):
        chosen.append("unmodelled_contacts")
    if not chosen:
        known = ", ".join(sorted({_without_number(n) for n in names}))
        raise ValueError(f'no quantity "{quantity}" for the event; there are {known}')
    order = [*other, *record_dims, level]
    events = np.zeros(status.transpose(*order).shape, dtype=bool)
    for name in ["collapsed", *chosen]:
        if name not in results:
            continue
        values = results[name].transpose(*order, ...).to_numpy()
        if results[name].attrs.get("compared_by") == "size":
            values = np.abs(values)
        with np.errstate(invalid="ignore"):
            found = values > 0 if name == "collapsed" else compare(values, threshold)
        events |= found.reshape(*events.shape, -1).any(axis=-1)
    ends = status.transpose(*order).to_numpy()
    outcome = np.where(ends == 2, 2, (events | (ends == 1)).astype(int))
    last = record_dims[-1] if record_dims else ""
    both_ways = last in results.coords and results[last].attrs.get("parameter") == "excitation.polarity"
    sizes = dict(results.sizes)
    intensity = results["intensity"]
    return {
        "title": results.attrs.get("title", ""),
        "intensity": intensity.attrs["long_name"],
        "units": intensity.attrs["units"],
        "study_unit": intensity.attrs["study_unit"],
        "quantity_units": results[chosen[0]].attrs.get("units", ""),
        "levels": intensity.to_numpy().tolist(),
        "cases": int(np.prod([sizes[d] for d in other], dtype=int)),
        "records": int(np.prod([sizes[d] for d in record_dims], dtype=int)),
        "together": sizes[last] if both_ways else 1,
        "outcomes": outcome.ravel().tolist(),
        "axes": [_axis(results, d) for d in other],
    }


def _axis(results: Any, dimension: str) -> dict[str, Any]:
    coordinates = []
    for name, values in results.coords.items():
        if values.dims != (dimension,) or values.attrs.get("long_name") == _core.index_title():
            continue
        text = values.dtype.kind in "UO"
        coordinates.append(
            {
                "name": name,
                "units": values.attrs.get("units", ""),
                "parameter": values.attrs.get("parameter", ""),
                "numbers": [] if text else values.to_numpy().astype(float).tolist(),
                "texts": values.to_numpy().astype(str).tolist() if text else [],
            }
        )
    return {"name": dimension, "size": results.sizes[dimension], "coordinates": coordinates}


def _without_number(name: str) -> str:
    base, _, number = name.rpartition("_")
    return base if base and number.isdigit() else name
