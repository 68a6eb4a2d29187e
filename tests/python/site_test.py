"""What the site is made with: links that lead nowhere are found, folders become pages. `./dev docs` builds it."""

import re

import docs
from doors import ROOT


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


def test_addresses_of_other_sites_have_their_form():
    """Whether they answer is asked by `./dev docs --links`, where there is a way out."""
    found = set()
    for document in docs.documents_of(ROOT):
        text = re.sub(r"^```.*?^```", "", (ROOT / document).read_text(), flags=re.MULTILINE | re.DOTALL)
        found |= set(re.findall(r"https?:[^)>\s`]*", text))
    assert len(found) >= 3
    for address in found:
        assert re.fullmatch(r"https?://[a-z0-9-]+(\.[a-z0-9-]+)+(/[\w.~%()/-]*)?(\?[\w.=&-]+)?(#[\w-]+)?", address), address
    numbers = re.findall(r"doi\s*=\s*[{\"](.*?)[}\"]", (ROOT / "docs/references.bib").read_text())
    assert len(numbers) > 10 and len(set(numbers)) == len(numbers)
    for number in numbers:
        assert re.fullmatch(r"10\.\d{4,9}/[^\s{}]+", number), number


def test_every_page_of_the_index_is_there():
    for name in docs.INDEX.split():
        if name.startswith(("docs/", "examples/")):
            assert (ROOT / f"{name.strip('<>')}.md").exists(), name
