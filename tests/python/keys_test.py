"""The JSON Schemas of cases and studies: valid under their draft, and what editors (Taplo) make of them."""

import json
import os
import pathlib
import re
import shutil
import subprocess

import key_tables
import pytest
from refused import refused

ROOT = pathlib.Path(__file__).parents[2]
TAPLO = ROOT / "build" / "taplo" / "node_modules" / ".bin" / "taplo"
# What no schema sees, by the reason.
BEYOND = {
    "bad_input": {
        "lengths that follow from other keys": """
            contact-restitution-length contact-stiffness-length damping-modal-length-rotations
            damping-modal-length delays-length gap-count gap-widths-length gap-widths-without-points
            generic-lists-length gravity-loads-length initial-length isolation-initial-length
            infill-count length-of-list link-length plan-polygon-pairs plan-suite-pairs matrices-not-square modal-damping-length modal-lengths
            modal-too-many plan-matrices-size plan-modal-shapes sections-count spectrum-reduction spectrum-table-length yield-length""",
        "places in plan": """
            plan-footprints-overlap plan-held-by-nothing plan-isolation-at-one-place plan-link-not-facing
            plan-not-held-against-rotation plan-polygon-area plan-polygon-centre plan-polygon-corners
            plan-accidental plan-accidental-far plan-polygon-court plan-polygon-crosses plan-polygon-link plan-polygon-overlap
            plan-polygon-part""",
        "order of numbers": """
            column-elevations-order gap-elevations-order matrices-elevations-order
            modal-elevations-order rayleigh-equal-periods rigid-elevations-order
            spectrum-table-order""",
        "moments of loads": "hinges-gravity plan-gravity-loads",
        "names of buildings": """
            between-order between-unknown-name building-name-twice initial-unknown-building
            link-order link-unknown-name""",
        "other files": """
            project-logo-missing project-logo-word record-channel-missing record-channel-outside record-column-missing
            record-column-outside record-component-missing record-component-of-one record-component-twice
            record-component-unknown record-count record-empty record-header record-heading-like-a-row
            record-heading-peak record-heading-unit
            record-is-folder record-missing-file record-nan record-pga-of-zeros record-ragged
            record-time-step-contradicts record-time-step-missing record-uneven-time
            record-unit-missing record-unit-of-at2 record-unit-of-network record-units-of-line-3
            record-values-or-channels record-velocity record-word shapes-etabs-column shapes-etabs-level
            plan-modal-file shapes-etabs-modes shapes-names-order shapes-file-columns
            shapes-file-elevation-twice shapes-file-elevation shapes-file-empty
            shapes-file-is-folder shapes-file-missing shapes-file-ragged shapes-file-rows
            shapes-file-upside-down shapes-file-word spectrum-file-column-missing
            spectrum-file-column-outside spectrum-file-missing spectrum-file-one-column
            spectrum-file-values spectrum-file-word""",
        "keys of several tables, or numbers of several keys": """
            code-no-rule column-axial-stiffness plan-axial-without-frames column-capacity-of-nothing column-elevations-missing
            column-of-a-stick columns-not-asked-for contact-axial-without-frames
            contact-damping-beyond-critical contact-damping-ratio-list-beyond-critical
            contact-filler-locking contact-filler-stiffness contact-missing contact-second-stiffness-list contact-second-stiffness damping-missing
            damping-stiffness-of-ratio displacements-motion duration-missing excitation-nothing-moves frame-width gap-missing
            generic-hardening-alone generic-of-plan-in-row plan-generic-and-rigidity plan-generic-yields
            matrices-alone-in-a-row modal-masses-missing
            isolation-of-plan-in-row plan-isolation-of-row plan-soil-twist soil-of-plan-in-row
            isolation-strength-alone link-does-nothing link-place-of-row plan-backbone-twice plan-beside-row plan-frame-yields
            contact-spread-in-row plan-friction-of-law plan-gap-width plan-link-without-place
            plan-accidental-below plan-accidental-spectrum
            plan-struck-without-frame plan-struck-without-mass
            plan-size-without-corner plan-suite-kinds plan-suite-same plan-suite-y-record matrices-damping-none
            matrices-damping-twice modal-with-calibration modal-with-p-delta modal-with-soil
            shear-capacity-dynamic shear-capacity-twice
            spectrum-damping-of-code spectrum-long-period spectrum-with-bearings-that-yield
            spectrum-with-delays spectrum-with-initial spectrum-with-links suite-period-missing
            suite-scale-table wave-without-width""",
        "what must be computed": """
            column-near-a-floor columns-stiffer-than-storey contact-floor-without-mass contact-restitution-beyond-relation
            damping-infinite damping-stiffness-negative elastic-modulus-huge frame-massless-floor
            frame-massless-rotations frequency-infinite frequency-too-high
            gap-elevation-without-floor gap-floors-named-twice gap-no-common-elevation
            gap-of-buildings-apart generic-yielding-wall harmonic-peak-infinite harmonic-period-tiny
            hinge-backbone-hardens hinge-backbone-steep infill-no-room infill-ultimate
            initial-overlap-restitution link-level-tolerance matrices-damping-not-semidefinite
            matrices-mass-diagonal matrices-not-definite matrices-not-symmetric modal-not-orthogonal
            plan-frame-loads plan-isolation-outside plan-matrices-indefinite plan-matrices-values
            plan-modal-not-orthogonal
            modal-shape-of-zeros output-step-tiny p-delta-critical rayleigh-negative-ratio
            section-overflow spectrum-table-short suite-factor-bounds suite-misfit suite-no-factor
            suite-table-ends suite-too-few weight-beyond-all""",
    },
    "bad_study": {
        "the case that it varies, and its files": """
            case-has-errors case-is-folder case-not-there distribution-above-one
            distribution-negative distribution-uniform-negative files-alone-in-case files-bad-record
            files-empty-glob files-mixed-units files-no-folder files-not-there
            files-unit-contradicts ida-component-of-row ida-harmonic ida-period-too-short ida-record-of-zeros
            ida-unscaled-of-zeros ida-unscaled-suite
            normalisation-file-not-there normalisation-file-short normalisation-of-zeros path-entry
            path-inside-another path-key-beside-others path-key-near path-malformed path-name-near path-not-a-list
            path-not-a-table path-table-near value-brings-about value-other-floors
            value-out-of-range value-range-end value-type vary-first-too""",
        "lengths that follow from other keys": """
            files-unit-count labels-count normalisation-count together-count""",
        "names, and what stands twice": """
            files-twice ida-name-taken ida-scale-of-y ida-varies-scale name-is-none name-of-companions name-taken
            name-twice path-twice path-units polarity-twice value-twice""",
        "keys of several tables, or numbers of several keys": """
            distribution-bounds distribution-in-grid grid-too-large ida-levels-order ida-levels-without-unit ida-missing
            ida-unscaled-normalised ida-unscaled-without-records
            ida-with-sampling range-backwards remedy-for-a-sweep remedy-without-range sweep-of-ida
            value-table-without-label vary-missing""",
    },
}


@pytest.fixture(scope="module")
def schemas(tmp_path_factory):
    program = os.environ.get("BENTUR_PROGRAM", "")
    if not program:
        pytest.skip("BENTUR_PROGRAM does not name the command line that writes schemas")
    folder = tmp_path_factory.mktemp("schemas")
    for what in ("case", "study"):
        subprocess.run([program, "schema", what, "-o", str(folder / f"{what}.json")], check=True, capture_output=True)
    return folder


def lint(schema, files):
    """Names of the files that Taplo refuses."""
    if not TAPLO.exists() or not shutil.which("node"):
        pytest.skip("Taplo is not in build/taplo: ./dev setup installs it where npm is")
    done = subprocess.run([str(TAPLO), "lint", "--schema", schema.as_uri(), "--colors", "never", *map(str, files)],
                          capture_output=True, text=True, cwd=schema.parent)
    return {pathlib.Path(name).name for name in re.findall(r'invalid file error=.* path="([^"]+)"', done.stderr)}, done.stderr


def test_schemas_are_valid_under_their_draft(schemas):
    jsonschema = pytest.importorskip("jsonschema", reason="python3-jsonschema is not installed")
    for what in ("case", "study"):
        schema = json.loads((schemas / f"{what}.json").read_text())
        assert schema["$schema"] == "http://json-schema.org/draft-04/schema#"
        jsonschema.Draft4Validator.check_schema(schema)


def cases_and_studies(root):
    files = sorted(root.glob("examples/**/*.toml"))
    studies = [file for file in files if re.search(r"^case = ", file.read_text(), re.MULTILINE)]
    return [file for file in files if file not in studies], studies


def test_every_example_is_valid(schemas, root):
    cases, studies = cases_and_studies(root)
    assert len(cases) > 20 and len(studies) > 10
    for schema, files in (("case", cases), ("study", studies)):
        refused, told = lint(schemas / f"{schema}.json", files)
        assert not refused, told


def test_a_case_is_checked_by_the_line_at_its_head(program, tmp_path):
    subprocess.run([program, "example", "free-impact", "-o", str(tmp_path)], check=True, capture_output=True)
    case = tmp_path / "free-impact.toml"
    check = [str(TAPLO), "lint", "--colors", "never", str(case)]
    if not TAPLO.exists() or not shutil.which("node"):
        pytest.skip("Taplo is not in build/taplo: ./dev setup installs it where npm is")
    assert subprocess.run(check, capture_output=True, cwd=tmp_path).returncode == 0
    case.write_text(case.read_text().replace("duration", "durration"))
    assert "durration" in subprocess.run(check, capture_output=True, text=True, cwd=tmp_path).stderr


@pytest.mark.parametrize("what, folder", [("case", "bad_input"), ("study", "bad_study")])
def test_what_a_schema_can_say_is_refused(schemas, root, what, folder):
    place = refused() if folder == "bad_input" else root / "tests" / folder
    files = [file for file in sorted(place.glob("*.toml")) if file.with_suffix(".expected").exists()]
    names = [name for reason in BEYOND[folder].values() for name in reason.split()]
    assert len(set(names)) == len(names)
    found, _ = lint(schemas / f"{what}.json", files)
    assert {file.stem for file in files} - {pathlib.Path(name).stem for name in found} == set(names)


def told_in(schema):
    for key, said in schema.get("properties", {}).items():
        yield key, said
        for below in (said, said.get("items", {}), *said.get("anyOf", []), *said.get("items", {}).get("anyOf", [])):
            yield from told_in(below)


def test_every_key_says_what_it_is(schemas):
    for what in ("case", "study"):
        keys = list(told_in(json.loads((schemas / f"{what}.json").read_text())))
        assert len(keys) > 40
        for key, said in keys:
            assert said["title"], key
            assert all(told["label"]["en"] and told["label"]["id"] for told in said["x-bentur"]), key


@pytest.mark.parametrize("document", key_tables.DOCUMENTS)
def test_tables_of_the_documents_are_what_the_schema_says(program, root, document):
    text = (root / document).read_text()
    assert key_tables.written(text, key_tables.schemas_of(program)) == text, "./dev keys writes them"


def test_the_list_of_keys_leads_to_all_of_these_tables(program, root):
    text = (root / key_tables.INDEX).read_text()
    assert key_tables.index(key_tables.texts_of(root), key_tables.schemas_of(program)) == text, "./dev keys writes it"
    for way in ("case-gaps.md#contact-laws", "studies.md#the-study-file", "separation-rules.md#code"):
        assert way in text


def test_the_list_of_keys_has_every_key_of_the_schemas(program, root):
    text = (root / key_tables.INDEX).read_text()
    listed = re.findall(r"^- `(.*?)`:", text, re.MULTILINE)
    assert len(set(listed)) == len(listed)
    of_schemas = {key for schema in key_tables.schemas_of(program).values() for key, _ in told_in(schema)}
    assert {"ratios", "half_space", "low", "title", "asce-7-16"} <= of_schemas
    assert of_schemas == set(listed)
