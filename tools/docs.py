"""docs.py ROOT OUT [--links]: the documentation site in OUT/html, by Sphinx with MyST; a warning is an error.

The documents stand in the repository as they are read there; here they are laid out under OUT/source in the same folders,
so that their links hold, with pages that are made from the sources: commands from what they say of themselves, Python from
its docstrings, C++ from its headers. --links also asks the addresses of other sites (Sphinx's linkcheck).
"""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

CONF = '''
project = "bentur"
author = "the authors of bentur"
version = release = "{version}"
extensions = ["myst_parser", "sphinx.ext.autodoc", "mathml"]
html_theme = "furo"
html_title = "bentur"
html_theme_options = {{"light_css_variables": {{"color-brand-primary": "{link[0]}", "color-brand-content": "{link[0]}"}},
                      "dark_css_variables": {{"color-brand-primary": "{link[1]}", "color-brand-content": "{link[1]}"}}}}
html_static_path = ["_static"]
html_css_files = ["bentur.css"]
html_copy_source = html_show_sourcelink = html_show_copyright = False
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 5
myst_links_external_new_tab = False
suppress_warnings = ["misc.highlighting_failure", "myst.header"]  # listings that are cut; headings that skip a level
autodoc_typehints = "signature"
autodoc_member_order = "bysource"
autodoc_type_aliases = {{name: name for name in ("Numbers", "Table", "ArrayLike")}}
exclude_patterns = ["_build"]
toc_object_entries = False
linkcheck_timeout = 20
'''

# MathML needs no script and no network; every browser of today draws it.
MATHML = '''
import re

import latex2mathml.converter
from docutils import nodes


def visit(display):
    def one(self, node):
        self.body.append(latex2mathml.converter.convert(node.astext().strip(), display=display))
        raise nodes.SkipNode

    return one


def by_name(app, what, name, obj, options, signature, returns):
    """Types by the names of autodoc_type_aliases, which Sphinx wraps where they stand in a union."""
    return tuple(re.sub(r"TypeAliasForwardRef\\('(\\w+)'\\)", r"\\1", one) if one else one for one in (signature, returns))


def setup(app):
    app.connect("autodoc-process-signature", by_name)
    app.add_html_math_renderer("mathml", (visit("inline"), None), (visit("block"), None))
    app.connect("config-inited", lambda app, config: setattr(config, "html_math_renderer", "mathml"))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
'''

CSS = '''
article table { display: block; overflow-x: auto; width: fit-content; max-width: 100%; }
article table td, article table th { vertical-align: top; }
@media (min-width: 700px) { article td:first-child code { white-space: nowrap; } }
body[data-theme="light"] article img { color-scheme: only light; }
body[data-theme="dark"] article img { color-scheme: only dark; }
@media (prefers-color-scheme: dark) { body[data-theme="auto"] article img { color-scheme: only dark; } }
article pre { font-size: 0.8rem; }
math[display="block"] { margin: 1rem 0; overflow-x: auto; }
'''

# What axe-core asks for and the theme leaves out.
ACCESSIBLE = {
    '<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">',
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="All pages">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="On this page">',
    '<th class="head"><p></p></th>': "<td></td>",
    "<pre>": '<pre tabindex="0">',
    '<div id="search-results"></div>': '<h1>Search</h1>\n<div id="search-results"></div>',
    '<table class="docutils': '<table tabindex="0" class="docutils',
}

INDEX = '''# bentur

Neighbouring buildings that stand too close hit each other in an earthquake. **bentur** (Indonesian: *to
collide*) computes what happens then: when and how hard each floor is struck, how much more the
buildings move than they would alone, and how wide the gap must be for them never to touch.

```{{toctree}}
:caption: Begin
:maxdepth: 1

docs/README
docs/start
docs/tutorials/designer
docs/tutorials/researcher
docs/tutorials/teacher
docs/tutorials/yielding-frame
docs/tutorials/twisting-pair
docs/questions
```

```{{toctree}}
:caption: How to
:maxdepth: 1

docs/modelling
docs/python
Studies and fragilities <docs/studies>
docs/report
docs/figures
docs/gallery
docs/studio
docs/examples/two-real-buildings
docs/examples/struck-columns
docs/howto/etabs_sap2000
docs/howto/block-of-houses
docs/howto/add_contact_law
docs/howto/add_element
docs/howto/add_output
docs/howto/add_building
```

```{{toctree}}
:caption: Reference
:maxdepth: 1

docs/case-file
docs/case-buildings
docs/case-foundations
docs/case-gaps
docs/case-plan
docs/case-motion
docs/result-files
docs/result-json
docs/result-quantities
docs/editor
docs/record-files
docs/separation-rules
docs/response-spectrum
docs/suites
Commands <reference/commands>
Python <reference/python>
C++ <reference/cpp>
docs/glossary
docs/notation
examples/README
```

```{{toctree}}
:caption: Theory and proof
:maxdepth: 1

{theory}
docs/verification
docs/performance
docs/monograph/README
```

```{{toctree}}
:caption: The project
:maxdepth: 1

README
docs/architecture
docs/decisions
docs/decisions-solver
docs/decisions-doors
CONTRIBUTING
CHANGELOG
```

```{{toctree}}
:caption: Beside the sources
:maxdepth: 1

{others}
```
'''


def commands(program):
    """What each command says of itself."""
    overall = subprocess.run([program, "--help"], capture_output=True, text=True, check=True).stdout
    page = ["# Commands", "", "As `bentur COMMAND --help` says it.", "", "```text", overall.strip(), "```", ""]
    names = re.findall(r"^  (\w+)  ", overall.split("SUBCOMMANDS:" if "SUBCOMMANDS:" in overall else "Subcommands:")[-1], re.MULTILINE)
    for name in names:
        text = subprocess.run([program, name, "--help"], capture_output=True, text=True, check=True).stdout
        page += [f"## bentur {name}", "", "```text", text.strip(), "```", ""]
    assert len(names) > 5, names
    return "\n".join(page)


def python_reference():
    import bentur

    groups = {
        "Cases": ["Case", "CaseError", "Finding", "example", "examples"],
        "What is done with them": ["run", "Result", "modes", "minimum_gap", "height_rules", "SolveError"],
        "Many runs": ["sweep", "ida", "vary", "fragility"],
        "Records": ["read_record", "Record", "response_spectrum", "Spectrum", "logarithmic_periods"],
        "Laws of one's own": ["ForceLaw", "BranchLaw", "Branch", "Guard"],
    }
    told = {name for names in groups.values() for name in names}
    groups["Tables of a case"] = [n for n in bentur.__all__ if n not in told and not n.startswith("_")]
    page = ["# Python", "", "From the docstrings of the package. The guide is [bentur from Python](../docs/python.md).", ""]
    for heading, names in groups.items():
        page += [f"## {heading}", ""]
        if heading == "Tables of a case":
            page += ["Numbers: a number, or a list or array of them. Table: a dictionary under the file's names.", ""]
        for name in names:
            kind = "autoclass" if isinstance(getattr(bentur, name), type) else "autofunction"
            kind = "autoexception" if name.endswith("Error") else kind
            members = "" if heading in ("Tables of a case",) or kind == "autofunction" else "   :members:\n"
            page += ["```{eval-rst}", f".. {kind}:: bentur.{name}", members, "```", ""]
    page += ["## bentur.plot", "", "```{eval-rst}", ".. automodule:: bentur.plot", "   :members:", "```", ""]
    return "\n".join(page)


def cpp_reference(root, out):
    """A page for each module, made of its public headers, and one that lists them."""
    order = re.search(r"set\(modules ([\w ]+)\)", (root / "CMakeLists.txt").read_text())[1].split()[::-1]
    page = ["# C++", "", "Each module with its public headers as they stand: what is said there is the reference. "
            "How to build with them: [README](../README.md#use-as-a-library).", "", "```{toctree}", ":maxdepth: 1", ""]
    for module in order:
        page.append(f"cpp-{module}")
        text = (root / "src/bentur" / module / "README.md").read_text()
        lines = [f"# {module}", "", re.sub(r"^# .*\n", "", text).strip().replace("](", "](../src/bentur/" + module + "/"), ""]
        for header in sorted((root / "src/bentur" / module).rglob("*.h")):
            if {"engine", "internal"} & set(header.parts):
                continue
            text = header.read_text().split("#pragma once", 1)[-1].strip()
            lines += [f"## {header.relative_to(root / 'src')}", "", "````cpp", text, "````", ""]
        (out / f"cpp-{module}.md").write_text("\n".join(lines))
    return "\n".join([*page, "```", ""])


def documents_of(root):
    """Names of the documents, from the folder of the project: those that git knows or, of an archive, all that are there."""
    if shutil.which("git") and (root / ".git").exists():
        return sorted(subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "*.md"],
                                     cwd=root, capture_output=True, text=True, check=True).stdout.split("\0")[:-1])
    made = {"build", "node_modules", ".git", "records"}
    return sorted(str(found) for one in root.rglob("*.md") if not made & set((found := one.relative_to(root)).parts))


def lay_out(root, source):
    """The documents with what they link to."""
    shutil.rmtree(source, ignore_errors=True)
    documents = documents_of(root)
    for name in documents:
        target = source / name
        target.parent.mkdir(parents=True, exist_ok=True)
        text = (root / name).read_text()
        for link in re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", text):
            there = (root / name).parent / link
            if there.is_dir():  # the page of a folder, or its name alone
                page = link.rstrip("/") + "/README.md"
                text = text.replace(f"]({link})", f"]({page})") if (there / "README.md").exists() else \
                    re.sub(r"\[([^\]]*)\]\(" + re.escape(link) + r"\)", r"\1", text)
            elif there.exists() and there.suffix != ".md":
                copy = (target.parent / link).resolve()
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(there, copy)
        target.write_text(text)
    return documents


class Page(html.parser.HTMLParser):
    """The places of a page, and where it leads."""

    def __init__(self, text):
        super().__init__()
        self.places, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        self.places |= {found[name] for name in ("id", "name") if found.get(name)}
        self.links += [found[name] for name in ("href", "src") if found.get(name)]


def broken_links(folder):
    """Links between the pages that lead nowhere, to a file or to a place in one."""
    pages = {path.resolve(): Page(path.read_text()) for path in folder.rglob("*.html")}
    count = 0
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            place = urllib.parse.unquote(parts.fragment)
            count += 1
            if not target.exists():
                yield f"{path.relative_to(folder)}: {link}: no such page"
            elif place and target in pages and place not in pages[target].places:
                yield f"{path.relative_to(folder)}: {link}: no such place"
    print(f"{count} links between {len(pages)} pages looked up")


def main(root, out, *options):
    root, out = pathlib.Path(root).resolve(), pathlib.Path(out).resolve()
    source = out / "source"
    documents = lay_out(root, source)
    reference = source / "reference"
    reference.mkdir()
    program = root / "build/release/apps/bentur/bentur"
    (reference / "commands.md").write_text(commands(program))
    (reference / "python.md").write_text(python_reference())
    (reference / "cpp.md").write_text(cpp_reference(root, reference))
    theory = sorted(name.removesuffix(".md") for name in documents if name.startswith("docs/theory/"))
    theory = "\n".join(theory)
    index = INDEX.format(theory=theory, others="")
    listed = set(re.findall(r"<?((?:docs|examples|reference|README|CONTRIBUTING|CHANGELOG)[\w/.-]*)>?$", index, re.MULTILINE))
    others = [n.removesuffix(".md") for n in documents if n.removesuffix(".md") not in listed]
    (source / "index.md").write_text(INDEX.format(theory=theory, others="\n".join(others)))
    (source / "_static").mkdir()
    (source / "_static/bentur.css").write_text(CSS)
    asked = ["cmake", "-P", str(root / "cmake" / "version.cmake")]
    version = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.strip()
    palette = (root / "src/bentur/report/figures/internal/colours.h").read_text()
    link = re.search(r'\{"link", "(.*?)", "(.*?)"', palette).groups()
    (source / "conf.py").write_text("import sys\nsys.path.insert(0, '.')\n" + CONF.format(version=version, link=link))
    (source / "mathml.py").write_text(MATHML)
    shutil.rmtree(out / "html", ignore_errors=True)
    builder = "linkcheck" if "--links" in options else "html"
    command = [sys.executable, "-m", "sphinx", "-W", "--keep-going", "-q", "-E", "-b", builder, source, out / builder]
    status = subprocess.run(command, cwd=source).returncode
    if status == 0:
        for page in (out / "html").rglob("*.html"):
            text = page.read_text()
            for given, wanted in ACCESSIBLE.items():
                text = text.replace(given, wanted)
            page.write_text(text)
        pages = len(list((out / "html").rglob("*.html")))
        print(f"{pages} pages without a warning: {out / 'html' / 'index.html'}" if builder == "html" else "links hold")
        broken = list(broken_links(out / "html")) if builder == "html" else []
        print("\n".join(broken), end="\n" if broken else "")
        status = bool(broken)
    sys.exit(status)


if __name__ == "__main__":
    main(*sys.argv[1:])
