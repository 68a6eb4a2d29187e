"""What is wrong with an argument is said by the name that the caller knows, never by what lies behind it."""

import functools

import numpy as np
import pytest

import bentur


def record():
    return np.sin(np.arange(400) / 20.0)


@functools.cache
def result():
    return bentur.run(bentur.example())


CALLS = {
    "case is a int": lambda: bentur.run(3),
    "case is a None": lambda: bentur.minimum_gap(None),
    "file is a float": lambda: bentur.Case.from_file(2.5),
    'file = ""': lambda: bentur.Case.from_file(""),
    "text is a bytes": lambda: bentur.Case.from_text(b"title = 1"),
    "folder is a int": lambda: bentur.Case.from_dict({}, folder=1),
    "values is a list": lambda: bentur.Case.from_dict([]),
    "output_step is a str": lambda: bentur.run(bentur.example(), output_step="0.01"),
    "output_step = -1": lambda: bentur.run(bentur.example(), output_step=-1),
    "at is a str": lambda: bentur.minimum_gap("study.toml", at="0.3"),
    "file is a list": lambda: bentur.read_record([]),
    "column is a str": lambda: bentur.read_record("a.txt", column="two"),
    "component is a int": lambda: bentur.read_record("a.txt", component=2),
    "skip_lines = -1": lambda: bentur.read_record("a.txt", skip_lines=-1),
    "time_step is a str": lambda: bentur.read_record("a.txt", time_step="0.01"),
    "format is a int": lambda: bentur.read_record("a.txt", format=2),
    r"periods\[1\] is a str": lambda: bentur.response_spectrum(record(), [1.0, "two"], unit="g", time_step=0.01),
    r"record is 50 × 2, must be one list of accelerations: give one column, as record\[:, 1\]":
        lambda: bentur.response_spectrum(np.zeros((50, 2)), unit="g", time_step=0.01),
    "record is a single number": lambda: bentur.response_spectrum(np.array(0.1), unit="g", time_step=0.01),
    "record is complex": lambda: bentur.response_spectrum(np.ones(9) * 1j, unit="g", time_step=0.01),
    "record is 2 masked values": lambda: bentur.response_spectrum(np.ma.masked_less(np.arange(9.0), 2), unit="g", time_step=0.01),
    "error: excitation.values is 2 masked values": lambda: bentur.example().replace({"excitation.values": np.ma.masked_less(np.arange(9.0), 2)}),
    "damping is a str": lambda: bentur.response_spectrum(record(), [1.0], unit="g", time_step=0.01, damping="5 %"),
    "first is a None": lambda: bentur.logarithmic_periods(None),
    "count = 0": lambda: bentur.logarithmic_periods(count=0),
    "name is a int": lambda: bentur.example(1),
    "study is a int": lambda: bentur.sweep(1),
    "threads = 0": lambda: bentur.sweep("study.toml", threads=0),
    "results is a dict": lambda: bentur.fragility({}),
    "probabilities is a float": lambda: bentur.fragility({}, probabilities=0.1),
    'method = "guess"': lambda: bentur.fragility({}, method="guess"),
    "method is a None": lambda: bentur.modes(bentur.example(), method=None),
    "values is a int": lambda: bentur.example().replace(5),
    "values is a None": lambda: bentur.vary(bentur.example(), None),
    r'values\["gap\[0\].width"\] is a float': lambda: bentur.vary(bentur.example(), {"gap[0].width": 0.1}),
    'building = "C", must be one of: Model 1, Model 2': lambda: bentur.example().matrices("C"),
    "building = 2, must be from 0 to 1": lambda: bentur.example().matrices(2),
    "building is a None": lambda: bentur.example().matrices(None),
    "folder is a None": lambda: result().save(None),
    'folder = ""': lambda: result().save(""),
    "kind is a int": lambda: result().plot(5),
    "width = -1": lambda: result().plot(width=-1),
    "start is a str": lambda: result().plot("force", start="1 s"),
    "gap = -1": lambda: result().plot("force", gap=-1),
    "elevation is a str": lambda: result().plot("force", elevation="3 m"),
    "language is a None": lambda: result().report(None),
    'file = "a.png", must end in': lambda: result().plot().save("a.png"),
}


def test_errors_of_vary_name_the_keys_and_no_folder():
    for values, told in (
        ({"gap[0].widht": [0.1]}, 'gap[0].widht is not a known key, did you mean "width"?'),
        ({"gap[0].width": [-1.0]}, "gap[0].width = -1, must be >= 0"),
        ({"gap[0].width": []}, 'values["gap[0].width"] is empty, must have at least one entry'),
    ):
        with pytest.raises(bentur.CaseError) as caught:
            bentur.vary(bentur.example("m12-harmonic"), values)
        assert str(caught.value) == f"error: {told}"


@pytest.mark.parametrize("named", CALLS)
def test_the_argument_is_named(named):
    with pytest.raises((TypeError, ValueError), match=f"^{named}"):
        CALLS[named]()
