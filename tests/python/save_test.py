"""What Result.save() never overwrites: the rules of `bentur run -o` (docs/result-files.md)."""

import subprocess

import pytest

import bentur

RESULTS = ["case.toml", "histories.nc", "impacts.csv", "summary.json"]


@pytest.fixture
def case(root, tmp_path):
    """A case in a folder of its own, whose record is called like one of the results."""
    folder = tmp_path / "study"
    folder.mkdir()
    text = (root / "examples" / "m12-el-centro.toml").read_text()
    record = text.split('file = "')[1].split('"')[0]
    (folder / "impacts.csv").write_bytes((root / "examples" / record).resolve().read_bytes())
    (folder / "mine.toml").write_text(text.replace(record, "impacts.csv"))
    return folder / "mine.toml"


def names(folder):
    return sorted(one.name for one in folder.iterdir())


def test_the_record_stays(case):
    before = (case.parent / "impacts.csv").read_bytes()
    for force in (False, True):
        with pytest.raises(bentur.RefusedOutput, match="impacts.csv: not written: is read by this very"):
            bentur.run(case).save(case.parent, force=force)
    assert (case.parent / "impacts.csv").read_bytes() == before
    assert names(case.parent) == ["impacts.csv", "mine.toml"]


def test_the_case_itself_is_no_copy(case, tmp_path):
    folder = tmp_path / "here"
    folder.mkdir()
    for name, source in (("case.toml", "mine.toml"), ("record.csv", "impacts.csv")):
        (folder / name).write_bytes((case.parent / source).read_bytes().replace(b'"impacts.csv"', b'"record.csv"'))
    before = (folder / "case.toml").read_bytes()
    written = bentur.run(folder / "case.toml").save(folder)
    assert folder / "case.toml" not in written
    assert (folder / "case.toml").read_bytes() == before


@pytest.mark.parametrize("name", RESULTS)
def test_what_somebody_has_stays(case, name, tmp_path):
    pytest.importorskip("netCDF4")
    folder = tmp_path / "results"
    folder.mkdir()
    (folder / name).write_text("mine")
    result = bentur.run(case)
    with pytest.raises(bentur.RefusedOutput, match=f"{name}: not written: .*force=True"):
        result.save(folder)
    assert (folder / name).read_text() == "mine"
    assert names(folder) == [name]
    assert len(result.save(folder, force=True)) == 4
    assert (folder / name).read_bytes() != b"mine"


def test_names_of_temporary_files_are_nobodys(case, tmp_path):
    folder = tmp_path / "results"
    folder.mkdir()
    for name in RESULTS:
        (folder / f"{name}.new").write_text("mine")
    bentur.run(case).save(folder)
    for name in RESULTS:
        assert (folder / f"{name}.new").read_text() == "mine"
    assert len(names(folder)) == 8


def test_results_are_replaced_by_either_door(case, program, tmp_path):
    pytest.importorskip("netCDF4")
    folder = tmp_path / "results"
    result = bentur.run(case)
    result.save(folder)
    assert names(folder) == RESULTS
    result.save(folder)
    subprocess.run([program, "run", case, "-q", "-o", folder], check=True)
    result.save(folder)
    assert names(folder) == RESULTS
    with pytest.raises(bentur.RefusedOutput, match="histories.nc: not written: .* have no histories"):
        bentur.run(case, histories=False).save(folder)


def test_a_folder_has_a_name(case, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ValueError, match='folder = ""'):
        bentur.run(case).save("")
    (tmp_path / "file").write_text("mine")
    with pytest.raises(bentur.RefusedOutput, match="is not a folder"):
        bentur.run(case).save(tmp_path / "file")
    assert names(tmp_path) == ["file", "study"]
