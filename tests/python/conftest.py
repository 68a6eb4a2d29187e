"""BENTUR_PROGRAM: the command line to compare with. The package is the one on PYTHONPATH, or the one installed."""

import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "tests" / "doors"), str(ROOT / "tools")]


def pytest_configure(config):
    config.addinivalue_line("filterwarnings", "ignore::bentur.RemarkWarning")  # examples have remarks


@pytest.fixture(scope="session")
def program():
    path = os.environ.get("BENTUR_PROGRAM", "")
    if not path:
        pytest.skip("BENTUR_PROGRAM does not name the command line to compare with")
    return path


@pytest.fixture(scope="session")
def root():
    return ROOT
