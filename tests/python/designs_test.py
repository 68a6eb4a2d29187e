"""Designs of experiments of one's own: rows, cases, samples; what a study says of its runs."""

import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest

import bentur
from cases import pair as longer_pair

pytest.importorskip("xarray")
pandas = pytest.importorskip("pandas")


def pair(**more):
    return longer_pair(**{"analysis": bentur.Analysis(duration=5.0), **more})


KEYS = ["gap[0].width", "building[0].damping", 'building["stiff"].stick.stiffnesses[0]']


def design(rows, seed=1):
    random = np.random.default_rng(seed)
    return pandas.DataFrame({
        KEYS[0]: random.choice([0.0, 0.01, 0.02], rows),  # discrete: many are alike
        KEYS[1]: random.uniform(0.02, 0.07, rows),
        KEYS[2]: random.uniform(6e6, 1e7, rows),
    })


def one_by_one(case, rows):
    return [bentur.run(case.replace(dict(row))) for row in rows.to_dict("records")]


def test_rows_of_a_design_are_the_runs_one_by_one():
    rows = design(12)
    rows.loc[12] = rows.loc[3]  # a row may stand twice
    found = bentur.vary(pair(), rows)
    assert dict(found.sizes)["row"] == 13
    expected = [one.summary["gaps"][0]["points"][0]["peak_force"] for one in one_by_one(pair(), rows)]
    assert found.peak_force.values.ravel().tolist() == expected
    assert found.width.values.tolist() == rows[KEYS[0]].tolist() and found.width.attrs["units"] == "m"
    by_lists = bentur.vary(pair(), {key: rows[key].to_numpy() for key in KEYS}, together=True)
    assert by_lists.identical(found) or by_lists.drop_attrs().equals(found.drop_attrs())
    grid = bentur.vary(pair(), design(2, seed=5).assign(**{KEYS[0]: [0.0, 0.01]}), together=False)
    assert {"width", "damping", "stiffnesses"} <= set(grid.sizes) and "row" not in grid.sizes


def test_columns_whose_last_words_are_alike_have_names_of_their_own():
    found = bentur.vary(pair(), {"building[0].damping": [0.02, 0.03], 'building["stiff"].damping': [0.04, 0.04]}, together=True)
    assert found.building0_damping.values.tolist() == [0.02, 0.03]
    assert found.buildingstiff_damping.values.tolist() == [0.04, 0.04]


def test_rows_that_are_wrong_are_told_by_their_keys():
    with pytest.raises(ValueError, match="one length to be taken together, there are 2 of gap.0..width, 1 of"):
        bentur.vary(pair(), {KEYS[0]: [0.1, 0.2], KEYS[1]: [0.02]}, together=True)
    with pytest.raises(bentur.CaseError, match=r"gap\[0\].width = -1, must be >= 0"):
        bentur.vary(pair(), {KEYS[0]: [0.0, -1.0, -2.0], KEYS[1]: [0.02] * 3}, together=True)


def test_of_many_errors_the_message_has_twenty():
    values = np.full(50, np.nan)
    with pytest.raises(bentur.CaseError) as caught:
        pair(excitation={"kind": "record", "values": values, "time_step": 0.01, "unit": "g"})
    assert len(caught.value.errors) == 50
    told = str(caught.value).splitlines()
    assert len(told) == 21 and told[-1] == "and 30 more: .errors has them all" and "values[0] = nan" in told[0]


def test_many_cases_are_the_runs_one_by_one(tmp_path):
    rows = design(6)
    cases = [pair().replace(dict(row)) for row in rows.to_dict("records")]
    values = np.sin(np.arange(400) / 8)
    cases.append(pair(excitation={"kind": "record", "values": values, "time_step": 0.01, "unit": "m/s2"}))
    found = bentur.run_many(cases, threads=2)
    expected = [bentur.run(case) for case in cases]
    for i, one in enumerate(expected):
        run = found.isel(case=i)
        assert float(run.peak_force.squeeze()) == one.summary["gaps"][0]["points"][0]["peak_force"]
        assert run.peak_displacement_1.values.tolist() == one.summary["buildings"][0]["peak_displacement"]
        assert bentur.Case.from_text(run.case_text.item()) == cases[i]
    assert found.peak_force.attrs["units"] == "N" and found.attrs["bentur_version"] == bentur.__version__
    assert found.case.values.tolist() == list(range(7))
    named = bentur.run_many(cases[:2], labels=["a", "b"], keep_cases=False)
    assert named.case.values.tolist() == ["a", "b"] and "case_text" not in named
    pytest.importorskip("netCDF4")
    found.to_netcdf(tmp_path / "many.nc")


def test_many_cases_in_plan():
    case = bentur.Case.from_file(Path(__file__).parents[2] / "examples/plan/twisting-pair.toml")
    wide = case.replace({"analysis.duration": 2.0})
    found = bentur.run_many([wide, wide])
    assert float(found.peak_force.isel(case=0).max()) == float(found.peak_force.isel(case=1).max())


def test_cases_that_do_not_go_together_are_named():
    other = pair(building=[*pair().to_dict()["building"], {"name": "third", "damping": 0.05, "stick": {
        "storey_heights": [3.0], "masses": [1e5], "stiffnesses": [5e6]}}],
        gap=[*pair().to_dict()["gap"], {"between": ["stiff", "third"], "width": 0.1,
                                         "contact": {"law": "linear", "stiffness": 1e8}}])
    with pytest.raises(ValueError, match=r"cases\[1\] has other numbers of floors"):
        bentur.run_many([pair(), other])
    with pytest.raises(ValueError, match=r"cases\[1\] has other units"):
        bentur.run_many([pair(), pair(units={"length": "cm", "force": "N"})])
    with pytest.raises(TypeError, match=r"cases\[1\] is a str"):
        bentur.run_many([pair(), "case.toml"])
    with pytest.raises(ValueError, match="cases is empty"):
        bentur.run_many([])


def test_own_laws_run_among_many():
    law = bentur.BranchLaw(branches=[bentur.Branch(stiffness=1e8, guards=[bentur.Guard(deformation=1.0, then=0)])])
    found = bentur.run_many([pair(), pair().replace({"gap[0].contact": law})])
    assert found.peak_force.values.ravel()[0] == pytest.approx(found.peak_force.values.ravel()[1], rel=1e-9)


class Uniform:
    """A distribution with a ppf, as scipy has them."""

    def __init__(self, low, high):
        self.low, self.high = low, high

    def ppf(self, u):
        return self.low + (self.high - self.low) * u


class Lognormal:
    def __init__(self, median, beta):
        self.median, self.beta = median, beta

    def ppf(self, u):
        from statistics import NormalDist

        return self.median * np.exp(self.beta * np.vectorize(NormalDist().inv_cdf)(u))


def test_samples_have_their_distributions_and_correlations():
    drawn = {"a": Lognormal(2.0, 0.5), "b": Uniform(0.0, 1.0), "c": {1: 0.2, 2: 0.8}, "d": ["x", "y"]}
    rows = bentur.sample(drawn, 4000, seed=3)
    assert rows["a"].median() == pytest.approx(2.0, rel=0.002) and np.log(rows["a"]).std() == pytest.approx(0.5, rel=0.01)
    # a latin hypercube has one in each stratum
    assert sorted((rows["b"] * 4000).astype(int)) == list(range(4000))
    assert (rows["c"] == 1).mean() == pytest.approx(0.2, abs=1e-3) and (rows["d"] == "x").mean() == pytest.approx(0.5, abs=1e-3)
    assert bentur.sample(drawn, 50, seed=3).equals(bentur.sample(drawn, 50, seed=3))
    for wanted in (-0.5, 0.3, 0.7):
        rows = bentur.sample({"a": Lognormal(2.0, 0.5), "b": Uniform(0.0, 1.0), "c": {1: 0.2, 2: 0.8}}, 20000,
                             correlation=[[1, wanted, 0.2], [wanted, 1, 0], [0.2, 0, 1]])
        found = rows.corr().to_numpy()
        # of Pearson's own spread at 20,000 rows, 1/√n = 0.007
        assert found[0, 1] == pytest.approx(wanted, abs=0.02) and found[0, 2] == pytest.approx(0.2, abs=0.03)
        assert found[1, 2] == pytest.approx(0, abs=0.03)


def test_samples_that_cannot_be_are_refused():
    two = {"a": Uniform(0, 1), "b": Lognormal(1.0, 2.0)}
    for correlation, told in (([[1, 0.5]], "1 × 2, must be 2 × 2"), ([[1, 0.5], [0.4, 1]], "symmetric"),
                              ([[1, 1.2], [1.2, 1]], "positive definite"), ([[1, 0.99], [0.99, 1]], "can have")):
        with pytest.raises(ValueError, match=told):
            bentur.sample(two, 10, correlation=correlation)
    with pytest.raises(TypeError, match=r'distributions\["a"\] is a float'):
        bentur.sample({"a": 1.0}, 10)


def test_scipy_designs_go_in_as_they_are():
    qmc = pytest.importorskip("scipy.stats.qmc")
    unit = qmc.Sobol(2, seed=1).random(8)
    rows = pandas.DataFrame(qmc.scale(unit, [0.0, 0.02], [0.05, 0.07]), columns=KEYS[:2])
    assert bentur.vary(pair(), rows).peak_force.shape[0] == 8


def test_a_run_warns_of_its_remarks_once_a_case():
    case = bentur.example()
    with pytest.warns(bentur.RemarkWarning, match="base shear") as told:
        result = bentur.run(case)
    assert len(told) == 1 and told[0].filename == __file__ and result.remarks
    assert str(result).splitlines()[-1].startswith("remark: ")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        bentur.run(case)


def test_a_study_warns_of_its_runs():
    with pytest.warns(bentur.RemarkWarning, match=r"2 of 2 runs have remarks, 0 in doubt: .*base_shear.* \(2\)"):
        bentur.vary(bentur.example(), {"gap[0].width": [0.2, 0.4]})


def test_an_own_design_from_a_file_may_repeat_too(program, tmp_path):
    (tmp_path / "case.toml").write_text(pair().to_toml())
    (tmp_path / "study.toml").write_text(
        'case = "case.toml"\n'
        '[[vary]]\nparameter = "gap[0].width"\nvalues = [0.0, 0.0, 0.01, 0.01]\ntogether = "row"\n'
        '[[vary]]\nparameter = "building[0].damping"\nvalues = [0.02, 0.05, 0.02, 0.05]\ntogether = "row"\n')
    out = tmp_path / "out.nc"
    subprocess.run([program, "sweep", tmp_path / "study.toml", "-q", "-o", out], check=True)
    found = bentur.sweep(tmp_path / "study.toml")
    assert found.width.values.tolist() == [0.0, 0.0, 0.01, 0.01] and found.row.values.tolist() == [0, 1, 2, 3]
