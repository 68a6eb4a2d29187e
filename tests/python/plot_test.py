"""Every function of bentur.plot draws what it is given, with units on its axes; types hold."""

import ast
import importlib.util
import shutil
import subprocess
import sys

import numpy as np
import pytest
from doors import ROOT

import bentur

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
import bentur.plot  # noqa: E402

CASE = bentur.example("kelvin-voigt-pair")


@pytest.fixture(scope="module")
def result():
    return bentur.run(CASE)


@pytest.mark.parametrize("name", ["displacement", "force", "opening", "loop", "envelope"])
def test_of_a_run(name, result):
    ax = getattr(bentur.plot, name)(result)
    assert "[m]" in ax.get_xlabel() + ax.get_ylabel() or "[kN]" in ax.get_ylabel()
    drawn = [line for line in ax.get_lines() if len(line.get_xdata()) > 2]
    assert drawn and {line.get_color() for line in drawn} <= {*bentur.plot.BUILDINGS, *bentur.plot.TONES}
    assert ax.figure.get_size_inches()[0] == pytest.approx(8.8 / 2.54)
    matplotlib.pyplot.close(ax.figure)


@pytest.mark.parametrize("name", ["m12-el-centro", "hinged-frame", "linked-pair", "isolated-moat", "generic-neighbour"])
def test_every_figure_of_a_run_is_that_of_the_program(name, program, tmp_path):
    """The same bytes as `bentur run --figures` writes, kind by kind, and no kind more or less."""
    case = ROOT / f"examples/{name}.toml"
    subprocess.run([program, "run", "-q", case, "--figures", "svg", "-o", tmp_path / "out"], check=True, capture_output=True)
    drawn = {file.stem: file.read_text() for file in (tmp_path / "out/figures").glob("*.svg")}
    found = bentur.run(case)
    assert set(found.figures) == set(drawn) and {"overview", "scene"} <= set(drawn)
    for kind, svg in drawn.items():
        assert found.plot(kind).svg == svg, kind


def test_figures_have_what_plot_is_asked_for(result):
    assert "Waktu" in result.plot("force", language="id")._repr_svg_()
    part = result.plot("opening", start=1, end=2, width=12)
    assert 'width="453.5' in part.svg and part.svg != result.plot("opening", width=12).svg
    with pytest.raises(ValueError, match="did you mean \"force\""):
        result.plot("fource")
    with pytest.raises(ValueError, match="must end in .svg"):
        result.plot("force").save("force.pdf")


@pytest.mark.parametrize("name", ["isolated-moat", "sweep"])
def test_scripts_beside_figures_draw_and_complain_of_nothing(name, program, tmp_path):
    if name == "sweep":
        study = f'case = "{ROOT}/examples/m12-el-centro.toml"\n' + "".join(
            f'[[vary]]\nparameter = "{what}"\nfrom = 0.1\nto = 0.3\ncount = 4\n' for what in ("gap[0].width", "building[1].calibrate_period"))
        (tmp_path / "study.toml").write_text(study)
        subprocess.run([program, "sweep", tmp_path / "study.toml", "-o", tmp_path / "s.nc", "-q"], check=True)
        for kind in ("peak-force", "amplification"):
            subprocess.run([program, "plot", tmp_path / "s.nc", kind, "-o", tmp_path / f"{kind}.svg"], check=True, capture_output=True)
    else:
        subprocess.run([program, "run", f"{ROOT}/examples/{name}.toml", "-q", "-o", tmp_path, "--figures", "svg"], check=True)
    scripts = sorted(tmp_path.rglob("*.py"))
    assert len(scripts) == 2 if name == "sweep" else len(scripts) > 5
    written = {script: script.with_suffix(".svg").read_bytes() for script in scripts}
    every = "import runpy, sys, matplotlib.pyplot as plt\nfor one in sys.argv[1:]:\n sys.argv = [one]\n runpy.run_path(one)\n plt.close()"
    drawn = subprocess.run([sys.executable, "-W", "error", "-c", every, *scripts], capture_output=True, text=True)
    assert (drawn.returncode, drawn.stderr) == (0, "")
    for script in scripts:
        assert "<path" in script.with_name(script.stem + "-drawn.svg").read_text(), script
        assert script.with_suffix(".svg").read_bytes() == written[script], script


def test_a_report_has_its_figures(result):
    assert result.report().count("<figure") > 4


def test_force_is_the_exact_course(result):
    """Its largest value is the peak, which samples miss."""
    ax = bentur.plot.force(result)
    largest = max(np.max(line.get_ydata()) for line in ax.get_lines())
    peak = max(point["peak_force"] for point in result.summary["gaps"][0]["points"])
    assert largest == pytest.approx(peak, rel=1e-12)
    assert result.histories["force"].max() < 0.95 * peak


def test_others():
    ax = bentur.plot.modes(CASE, "New", count=2)
    assert len(ax.get_lines()) == 3 and ax.get_title() == "New"
    spectra = [bentur.response_spectrum(ROOT / "data/el-centro-1940-ns.csv", unit="g", damping=z) for z in (0.02, 0.05)]
    ax = bentur.plot.spectrum(*spectra)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["damping 2 %", "damping 5 %"]
    assert ax.get_ylabel().endswith("[m/s²]")


def test_a_fragility_without_a_fit_shows_its_fractions():
    counts = [{"intensity": level, "runs": 4, "events": events} for level, events in ((0.1, 0), (0.2, 4))]
    curve = {"case": {"width": 0.02}, "median": None, "dispersion": None, "counts": counts}
    intensity = {"name": "peak ground acceleration", "units": "980 cm s-2", "levels": [0.1, 0.2]}
    ax = bentur.plot.fragility({"curves": [curve], "intensity": intensity, "event": "impacts > 0"})
    assert [list(line.get_ydata()) for line in ax.get_lines()] == [[0, 1]]
    assert ax.get_xlabel() == "peak ground acceleration [g]"


def test_lines_of_a_study_say_what_they_are_of():
    pytest.importorskip("xarray")
    found = bentur.vary(CASE, {"gap[0].width": [0.02, 0.05], "building[0].damping": [0.02, 0.05]})
    ax = bentur.plot.against(found, "peak_force", "width")
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["damping = 0.02", "damping = 0.05"]


def test_stubs_are_python():
    for stub in sorted((ROOT / "bindings/python/bentur").glob("*.pyi")):
        ast.parse(stub.read_text(), stub.name)


def test_types(tmp_path):
    """mypy, strict, over the package and the examples, where it is installed."""
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is not installed")
    files = [ROOT / "bindings/python/bentur", *(ROOT / "examples/python").glob("*.py")]
    mypy = [shutil.which("mypy")] if shutil.which("mypy") else [sys.executable, "-m", "mypy"]
    run = subprocess.run(
        [*mypy, "--config-file", ROOT / "pyproject.toml", "--cache-dir", tmp_path, *files],
        capture_output=True, text=True, cwd=ROOT, env={"MYPYPATH": str(ROOT / "bindings/python"), "PATH": "/usr/bin:/bin"},
    )
    assert run.returncode == 0, run.stdout


def test_a_fragility_alone_has_its_bounds():
    """On levels that grow by one factor, whose bounds are where the answer has them."""
    levels, ends = [0.1, 0.2, 0.4], [[0.02, 0.2], [0.3, 0.7], [0.8, 0.97]]
    counts = [{"intensity": x, "runs": 4, "events": k, "probability": 0.5, "bounds": b} for x, k, b in zip(levels, (0, 2, 4), ends, strict=True)]
    found = {"curves": [{"case": {}, "median": 0.2, "dispersion": 0.4, "counts": counts}], "event": "impacts > 0", "bootstrap": {"confidence": 0.9},
             "intensity": {"name": "spectral acceleration, period 1 s, damping 5 %", "units": "gravity", "levels": levels}}
    ax = bentur.plot.fragility(found)
    corners = ax.collections[0].get_paths()[0].vertices
    for x, (low, high) in zip(levels, ends, strict=True):  # the nearest of 400 points, a part in 300 away at most
        at = corners[np.abs(np.log(corners[:, 0] / x)) < 0.004, 1]
        assert np.min(at) == pytest.approx(low, abs=0.01) and np.max(at) == pytest.approx(high, abs=0.01)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["90 % bounds", "lognormal fit", "observed"]
    assert ax.get_xscale() == "log" and ax.get_xlabel() == "spectral acceleration at 1 s, 5 % damping [g]"
