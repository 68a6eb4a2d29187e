"""What the site is made with: links that lead nowhere are found, folders become pages. `./dev docs` builds it."""

import importlib.util
import pathlib

ROOT = pathlib.Path(__file__).parents[2]
spec = importlib.util.spec_from_file_location("docs", ROOT / "tools" / "docs.py")
docs = importlib.util.module_from_spec(spec)
spec.loader.exec_module(docs)


def test_broken_links(tmp_path):
    (tmp_path / "a.html").write_text(
        '<h1 id="top">A</h1><a href="b.html#here">1</a><a href="b.html#gone">2</a><img src="no.svg">'
        '<a href="#top">3</a><a href="#bottom">4</a><a href="https://example.org/">5</a>'
    )
    (tmp_path / "b.html").write_text('<p id="here">B</p>')
    found = sorted(docs.broken_links(tmp_path))
    assert [line.split(": ")[1] for line in found] == ["#bottom", "b.html#gone", "no.svg"]


def test_documents_keep_their_links(tmp_path):
    documents = docs.lay_out(ROOT, tmp_path / "source")
    assert "docs/start.md" in documents and (tmp_path / "source/docs/figures").is_dir()
    readme = (tmp_path / "source/README.md").read_text()
    assert "](docs/theory/)" not in readme and "[docs/theory/]" not in readme
    assert (tmp_path / "source/LICENSE").exists()


def test_every_page_of_the_index_is_there():
    for name in docs.INDEX.split():
        if name.startswith(("docs/", "examples/")):
            assert (ROOT / f"{name.strip('<>')}.md").exists(), name
