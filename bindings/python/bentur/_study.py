"""Many runs: sweeps, incremental dynamic analyses, fragilities."""

from __future__ import annotations

import json
import os
import re
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import astuple, replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments, _core
from ._case import Case, as_case
from ._dataset import attributes_of_study, dataset, netcdf
from ._errors import CaseError, Finding, RemarkWarning, imported
from ._functions import Progress, shown
from ._own_laws import OwnLaw, table_of

if TYPE_CHECKING:
    import pandas
    import xarray

_TOGETHER = 16  # runs given to a thread at a time: enough for runs of one group to share their work


def sweep(
    study: str | PathLike[str],
    *,
    output: str | PathLike[str] | None = None,
    resume: bool = False,
    force: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> xarray.Dataset:
    """Runs a study file (docs/studies.md), as ``bentur sweep`` does and with the same numbers, into a Dataset with the
    names, dimensions and units of its file of results. Without `output` everything is kept in memory alone.

    :param output: the file of results, NetCDF. Until all runs are done theirs stand in ``OUTPUT.part``, which is kept
        whatever ends the program, and which the command goes on with as well.
    :param resume: goes on with the runs that ``OUTPUT.part`` lacks; finished results of this study are read. Where
        there is neither it begins anew.
    :param force: a file that is not results of the same kind may be replaced.
    :param threads: default: one per processor. Ctrl-C stops them all.
    :raises CaseError: with all that is wrong in study, case and records.
    :raises RefusedOutput: where writing there would harm a file.
    :raises RuntimeError: naming the file, where it cannot be written, or ``OUTPUT.part`` is there: of another study,
        or without `resume`.
    :raises ImportError: without xarray; with `output` without netCDF4.
    """
    return _run(study, False, (output, resume, force), threads, progress)


def ida(
    study: str | PathLike[str],
    *,
    output: str | PathLike[str] | None = None,
    resume: bool = False,
    force: bool = False,
    threads: int | None = None,
    progress: Progress = None,
) -> xarray.Dataset:
    """An incremental dynamic analysis: a study with ``[ida]``, as ``bentur ida`` runs it. See :func:`sweep`."""
    return _run(study, True, (output, resume, force), threads, progress)


def _run(
    study: str | PathLike[str],
    is_ida: bool,
    asked: tuple[str | PathLike[str] | None, bool, bool],
    threads: int | None,
    progress: Progress,
) -> xarray.Dataset:
    imported("xarray", "a study")
    output, resume, force = asked
    if output is None and (resume or force):
        raise ValueError(f"{'resume' if resume else 'force'} goes with output, the file of results")
    threads = _threads(threads)
    core = _core.Study(_arguments.path("study", study), is_ida, _for_each(threads))
    if output is None:
        return _solved(core, threads, progress)
    file = _arguments.path("output", output)
    imported("netCDF4", "results in a file")

    def write(unfinished: Path) -> None:
        Path(unfinished).write_bytes(netcdf(*core.variables()) or b"")

    if core.begin(file, resume, force, attributes_of_study):
        try:
            _solve(core, threads, progress)
            core.finish(write)
        finally:
            core.close()
    found: xarray.Dataset = imported("xarray", "a study").load_dataset(file)
    return found


def _for_each(workers: int) -> Callable[[int, Callable[[int, int], None]], None]:
    """By which values of a study are tried, part by part."""

    def by_threads(count: int, part: Callable[[int, int], None]) -> None:
        at_once = max(1, -(-count // (4 * workers)))
        starts = range(0, count, at_once)
        if workers == 1 or len(starts) < 2:
            part(0, count)
            return
        with ThreadPoolExecutor(workers) as pool:
            for one in [pool.submit(part, start, min(start + at_once, count)) for start in starts]:
                one.result()

    return by_threads


def _threads(threads: int | None) -> int:
    if threads is None:
        return len(os.sched_getaffinity(0))
    return _arguments.whole("threads", threads, 1, 4096)


def _solved(core: _core.Study, threads: int, progress: Progress) -> xarray.Dataset:
    _solve(core, threads, progress)
    found: xarray.Dataset = dataset("a study", *core.variables())
    _warn_of_runs(found)
    return found


def _counted_flags(flagged: xarray.DataArray) -> str:
    """In how many runs each flag of a variable is set: "drift (3), pga (1)"."""
    flags = np.nan_to_num(flagged.to_numpy()).astype(np.uint64).ravel()
    about = []
    for bit, key in enumerate(str(flagged.attrs["flag_meanings"]).split()):
        if runs := int((flags >> np.uint64(bit) & np.uint64(1)).sum()):
            about.append(f"{key} ({runs})")
    return ", ".join(about)


def _warn_of_runs(found: xarray.Dataset) -> None:
    """How many runs have remarks, and about what; of how many it is not known what gap they need."""
    if "open_needs" in found and (unknown := int((found.open_needs > 0).sum())):
        warnings.warn(
            f"of {unknown} of {found.open_needs.size} runs it is not known what gap they need: "
            f"{_counted_flags(found.open_needs)}; `open_needs` says which",
            RemarkWarning,
            stacklevel=4,
        )
    if "remarks" not in found or not (found.remarks > 0).any():
        return
    remarked, doubted = int((found.remarks > 0).sum()), int((found.doubts > 0).sum())
    warnings.warn(
        f"{remarked} of {found.remarks.size} runs have remarks, {doubted} in doubt: "
        f"{_counted_flags(found.remark_kinds)}; `remarks`, "
        "`doubts` and `remark_kinds` say which",
        RemarkWarning,
        stacklevel=4,
    )


def _solve(core: _core.Study, workers: int, progress: Progress) -> None:
    runs = core.runs
    done = 0
    # Work is handed out piece by piece, so that no more than some results wait at a time and Ctrl-C is heard at once.
    starts = iter(range(0, runs, _TOGETHER))
    with shown(progress, core.title or "runs") as show, ThreadPoolExecutor(workers) as pool:
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
    values: Mapping[str, Sequence[Any] | NDArray[Any]] | pandas.DataFrame,
    *,
    together: bool | None = None,
    labels: Mapping[str, Sequence[str]] | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> xarray.Dataset:
    """A sweep made in Python, by the keys of the case: the full grid of all values, or the rows of a design.

    ``bentur.vary(case, {"gap[0].width": [0.0, 0.01, 0.02], "excitation.pga": [2.0, 4.0]})`` has six runs,
    ``together=True`` takes lists of one length row by row, and a DataFrame, whose columns are keys, is rows by itself.
    Rows may be alike, as those of a factorial design, of Saltelli or of Morris are; :func:`sample` draws some.

    Files are relative to the folder of the case, as in the case itself.

    :param together: whether the values are rows; default: those of a DataFrame are.
    :param labels: what the results call values that are no numbers, by the same keys; default texts themselves.
    :returns: as :func:`sweep`; rows along the dimension ``row``.
    :raises CaseError: with all that is wrong in any of the values.
    """
    given_values = _columns(values)
    if together is None:
        together = hasattr(values, "columns")
    if together and len({len(one) for one in given_values.values()}) > 1:
        lengths = ", ".join(f"{len(one)} of {key}" for key, one in given_values.items())
        raise ValueError(f"values must have one length to be taken together, there are {lengths}")
    names = _names(given_values)
    tables = []
    for key, given in given_values.items():
        levels = [table_of(level, key) for level in given]
        one: dict[str, Any] = {"parameter": key, "values": levels}
        if key in names:
            one["name"] = names[key]
        if together:
            one["together"] = "row"
        if labels and key in labels:
            one["labels"] = list(labels[key])
        elif levels and all(isinstance(level, OwnLaw) for level in given):
            one["labels"] = [level.name for level in given]
        tables.append(one)
    texts = _core.toml_file({"case": "case.toml", "vary": tables}), case.to_toml()
    imported("xarray", "a study")
    try:
        workers = _threads(threads)
        return _solved(_core.Study(case._made, {"vary": tables}, *texts, _for_each(workers)), workers, progress)
    except CaseError as error:
        raise CaseError(_as_given(one, list(given_values)) for one in error.errors) from None


def _columns(values: Any) -> dict[str, list[Any]]:
    """Lists of values by their keys, of a mapping or a DataFrame."""
    if hasattr(values, "columns") and hasattr(values, "to_dict"):
        return {str(key): values[key].tolist() for key in values.columns}
    found = {}
    for key, given in _arguments.mapping("values", values, "lists of values by their keys").items():
        if isinstance(given, str) or not isinstance(given, Iterable):
            raise TypeError(f'values["{key}"] is a {type(given).__name__}, must be a list of values')
        found[key] = list(given)
    return found


def _names(keys: Iterable[str]) -> dict[str, str]:
    """Names in the results, of those keys whose last words are alike: ``building0_damping``."""
    last: dict[str, list[str]] = {}
    for key in keys:
        words = re.findall(r"[A-Za-z_]+", key.rpartition(".")[2])
        last.setdefault(words[0] if words else "", []).append(key)
    alike = [key for group in last.values() if len(group) > 1 for key in group]
    joined = {key: re.sub(r"""\["?([^\]"]*)"?\]""", r"\1", key) for key in alike}
    return {key: re.sub(r"\W+", "_", name, flags=re.ASCII) for key, name in joined.items()}


def run_many(
    cases: Iterable[Case],
    *,
    labels: Sequence[str] | None = None,
    keep_cases: bool = True,
    threads: int | None = None,
    progress: Progress = None,
) -> xarray.Dataset:
    """Runs cases of any kind, one after the other on all processors, into one Dataset with the quantities that a study
    keeps of each run, along the dimension ``case``.

    The cases may differ in whatever they like but for units and the numbers of floors, contact points and links. What
    varies by key is done faster by :func:`vary`, whose runs share what is alike in them.

    :param labels: what the results call the cases; default: numbers from 0.
    :param keep_cases: whether ``case_text`` has each case as :meth:`Case.to_toml` writes it.
    :raises ValueError: naming the case that does not go with the first.
    """
    all_cases = list(cases)
    for number, one in enumerate(all_cases):
        if not isinstance(one, Case):
            raise TypeError(f"cases[{number}] is a {type(one).__name__}, must be a bentur.Case")
    if not all_cases:
        raise ValueError("cases is empty, must have at least one")
    names = [] if labels is None else [_arguments.text(f"labels[{i}]", one) for i, one in enumerate(labels)]
    if labels is not None and len(names) != len(all_cases):
        raise ValueError(f"labels has {len(names)} entries, must have one per case, {len(all_cases)}")
    imported("xarray", "a study")
    study = _core.Study.of_cases([one._made for one in all_cases], names)
    found = _solved(study, _threads(threads), progress)
    if keep_cases:
        texts = np.array([one.to_toml() for one in all_cases], dtype=object)
        found["case_text"] = ("case", texts, {"long_name": "the case as a file"})
    return found


def _as_given(found: Finding, keys: Sequence[str]) -> tuple[str, int, int, str, str, str, str, str]:
    """An error of a study that Python has made, under the names of the arguments that it was made of."""

    def given(text: str) -> str:
        return re.sub(
            r"\bvary\[(\d+)\]\.(\w+)",
            lambda at: f'{"labels" if at[2] == "labels" else "values"}["{keys[int(at[1])]}"]',
            text,
        )

    return astuple(replace(found, message=given(found.message), key=given(found.key)))


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
    method: str = "likelihood",
) -> dict[str, Any]:
    """Fragility curves, and the gap for a pounding probability, as ``bentur fragility --json`` has them.

    :param results: of :func:`ida`, or of ``bentur ida`` by ``xarray.open_dataset``.
    :param event: ``"QUANTITY > NUMBER"`` (also >= < <=) in the units of the results; true of a run where any point,
        floor or gap has it.
    :param at: intensity for the gaps, in the unit of the levels; goes with `probabilities`, each in (0, 1).
    :param along: the gap width that is meant, where several vary.
    :param method: of θ and β: "likelihood", or of events that exceed a number above 0 "cloud" or "stripes".
    :raises ValueError: where the results do not have what is asked for.
    """
    method = _arguments.one_of("method", method, _core.fragility_methods())
    wanted = _arguments.listed("probabilities", probabilities)
    if not hasattr(results, "data_vars"):
        raise TypeError(f"results is a {type(results).__name__}, must be an xarray.Dataset of bentur.ida")
    if (at is None) != (len(wanted) == 0):
        raise ValueError("at and probabilities go together")
    if not all(0 < p < 1 for p in wanted):
        raise ValueError("probabilities must be in (0, 1)")
    told = _core.fragility_json(
        results,
        _arguments.text("event", event),
        resamples=_arguments.whole("resamples", resamples, 0, 10**6),
        confidence=_arguments.number("confidence", confidence),
        seed=_arguments.whole("seed", seed, 0, 2**64 - 1),
        at=None if at is None else _arguments.number("at", at),
        probabilities=wanted,
        along=_arguments.text("along", along),
        method=method,
    )
    found: dict[str, Any] = json.loads(told)
    return found


def risk(
    results: xarray.Dataset,
    hazard: str | PathLike[str] | tuple[Sequence[float], Sequence[float]],
    event: str = "impacts > 0",
    *,
    unit: str | None = None,
    site: int | None = None,
    years: float = 50.0,
    target: float | None = None,
    resamples: int = 1000,
    confidence: float = 0.95,
    seed: int = 1,
    method: str = "likelihood",
    language: str = "en",
) -> dict[str, Any]:
    """How often a year: the fragility of an event times the hazard of a site, as ``bentur risk --json`` has it, and in
    words under ``verdict`` (docs/risk.md).

    :param results: of :func:`ida`.
    :param hazard: a file, as the command takes it, or intensities and the mean annual frequencies [1/year] at which
        they are exceeded.
    :param event: as of :func:`fragility`.
    :param unit: of the intensities, where a file does not say it; default that of the levels.
    :param site: which of several in a file, from 1.
    :param years: that a probability is told for.
    :param target: probability of pounding in so many years that a gap is sought for.
    :raises CaseError: with what is wrong in the hazard.
    :raises ValueError: where results and hazard do not go together.
    """
    if not hasattr(results, "data_vars"):
        raise TypeError(f"results is a {type(results).__name__}, must be an xarray.Dataset of bentur.ida")
    is_text = isinstance(hazard, tuple)
    if isinstance(hazard, tuple):
        if len(hazard) != 2:
            raise ValueError(f"hazard has {len(hazard)} entries, must be intensities and frequencies")
        x, rate = (_arguments.listed(name, one) for name, one in zip(("intensities", "frequencies"), hazard, strict=True))
        if len(x) != len(rate):
            raise ValueError(f"hazard has {len(x)} intensities and {len(rate)} frequencies")
        given = "".join(f"{a!r} {b!r}\n" for a, b in zip(x, rate, strict=True))
    else:
        given = _arguments.path("hazard", hazard)
    if target is not None and not 0 < _arguments.number("target", target) < 1:
        raise ValueError(f"target = {target:g}, must be in (0, 1)")
    told, lines = _core.risk_json(
        results,
        given,
        is_text,
        _arguments.text("event", event),
        unit="" if unit is None else _arguments.text("unit", unit),
        site=None if site is None else _arguments.whole("site", site, 1),
        years=_arguments.positive("years", years),
        target=target,
        resamples=_arguments.whole("resamples", resamples, 1, 10**6),
        confidence=_arguments.number("confidence", confidence),
        seed=_arguments.whole("seed", seed, 0, 2**64 - 1),
        method=_arguments.one_of("method", method, _core.fragility_methods()),
        language=_arguments.text("language", language),
    )
    found: dict[str, Any] = json.loads(told)
    found["verdict"] = lines
    return found


def remedy(
    study: Case | str | PathLike[str],
    *,
    journal: str | PathLike[str] | None = None,
    resume: bool = False,
    progress: Progress = None,
) -> dict[str, Any]:
    """Seeks the gap, damper, filler or stiffness for which the objective of a study with ``[remedy]``
    (docs/studies.md) is least, and with a limit the smallest choice that keeps it, as ``bentur remedy --json``
    has it. Of a case, or its file, the least gap, which wants no search.

    :param journal: of a search: a file that keeps what has been tried until it is done; with `resume` it goes on there.
    :returns: ``best`` and ``smallest`` with ``values`` by name, ``objective`` and ``size``, None where there is none;
        all ``evaluations``. Of a case ``gaps``.
    :raises CaseError: where the study or its case has an error.
    :raises RefusedOutput: where the journal is there and not to be gone on with, or is another study's.
    """
    if resume and journal is None:
        raise ValueError("resume needs a journal")
    if isinstance(study, Case) or not _core.is_study(_arguments.path("study", study)):
        if journal is not None:
            raise ValueError("journal is for a study with [remedy]")
        return _least_gap(as_case(study)._made, progress)
    kept = None if journal is None else Path(_arguments.path("journal", journal))
    with shown(progress, "remedy") as told:
        made = _core.remedy_json(_arguments.path("study", study), "" if kept is None else kept, resume, told)
    found: dict[str, Any] = json.loads(made)
    if kept is not None and not found["stopped"]:
        kept.unlink(missing_ok=True)
    return found


def _least_gap(case: _core.Case, progress: Progress) -> dict[str, Any]:
    with shown(progress, "gap") as told:
        ask = _core.suite_least_gap_json if case.records else _core.least_gap_json
        found: dict[str, Any] = json.loads(ask(case, told))
        return found
