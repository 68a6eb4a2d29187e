"""key_tables.py PROGRAM [DOCUMENT...]: writes the tables of keys in the documents from the schemas of PROGRAM, bentur.

A table stands between two comments. `<!-- keys building.frame -->` is of the keys of a table; with `kind=record` after
it of those that are for that word of `kind` alone, with `kind=` of those that are for all, with `law` of those that are
for some; keys after a minus, `-unit -format`, are left out, as the text says where they are explained.
`<!-- words gap.contact law -->` is of the words of a key and what each needs. A way that begins with `study` is into a
study. docs/keys.md lists all of these keys with the places of their tables. tests/python/keys_test.py finds
what is not as it would be written.
"""

import json
import pathlib
import re
import subprocess
import sys

from wrap import wrapped

PAGES = pathlib.Path(__file__).resolve().parents[1] / "docs"
DOCUMENTS = (*sorted(f"docs/{page.name}" for page in PAGES.glob("case-*.md")), "docs/studies.md", "docs/suites.md")
BLOCK = re.compile(r"(<!-- (keys|words) ([^>]*?) -->\n)(.*?)(<!-- /\2 -->\n)", re.DOTALL)


def table_at(schema, way):
    for step in way.split(".") if way else ():
        schema = schema["properties"][step]
        schema = schema.get("items", schema)
        schema = next((one for one in schema.get("anyOf", []) if "properties" in one), schema)
    return schema["properties"]


def cell(text):
    return text.replace("|", "\\|")


def row_of(told):
    value = told["value"] + (": " if told["value"] and told["doc"] else "") + told["doc"]
    if len(told.get("word_docs", [])) == 2:  # more of them have a table of their own
        value = "; ".join(f'`"{word}"`: {doc}' for word, doc in zip(told["words"], told["word_docs"], strict=True))
    if told.get("with") and told["with"] not in value:
        value += f"; with `{told['with']}`"
    return value, told.get("default", "")


def keys_table(properties, choice):
    left_out = {one[1:] for one in choice.split() if one.startswith("-")}
    assert left_out <= set(properties), left_out - set(properties)
    by, equals, word = " ".join(one for one in choice.split() if not one.startswith("-")).partition("=")
    rows = {}
    for key, schema in properties.items():
        if key in left_out:
            continue
        for told in schema["x-bentur"]:
            of = told.get("when", {}).get(by)
            if equals and not word and of or by and not equals and not of or word and word not in (of or []):
                continue
            value, default = row_of(told)
            if (key, value, default) not in rows:
                others = [f'`{name} = "{one}"`' for name, words in told.get("when", {}).items()
                          for one in words if name != by and name != "rigid"]
                rows[key, value, default] = " or ".join(others)
    lines = ["| key | value | default |", "|---|---|---|"]
    for (key, value, default), others in rows.items():
        lines.append(f"| `{key}` | {cell(value)}{'; of ' + others if others else ''} | {cell(default)} |".replace("|  |", "| |"))
    return lines


def words_table(properties, by):
    told = properties[by]["x-bentur"][0]
    lines = [f"| `{by}` | what it does | keys |", "|---|---|---|"]
    for word, doc in zip(told["words"], told["word_docs"], strict=True):
        needed, one_of, may = [], [], []
        for key, schema in properties.items():
            for one in schema["x-bentur"]:
                if word in one.get("when", {}).get(by, []):
                    (needed if one["need"] == "required" else one_of if one["need"] == "one_of" else may).append(f"`{key}`")
        keys = ", ".join(needed)
        if one_of:
            keys += (" and one of " if keys else "one of ") + ", ".join(one_of)
        if may:
            keys += ("; " if keys else "") + "may have " + ", ".join(may)
        lines.append(f'| `"{word}"` | {cell(doc)} | {keys} |')
    return lines


def table_of(what, schemas):
    """The keys of a table and the choice among them that a comment asks for: "building.frame", "study ida law"."""
    way, _, choice = what.partition(" ")
    schema = schemas["case"]
    if way == "study":
        schema, (way, _, choice) = schemas["study"], choice.partition(" ")
    return table_at(schema, way), choice


def written(text, schemas):
    def block(found):
        head, kind, what, _, tail = found.groups()
        properties, choice = table_of(what, schemas)
        lines = words_table(properties, choice) if kind == "words" else keys_table(properties, choice)
        return head + "\n".join(lines) + "\n" + tail

    return BLOCK.sub(block, text)


def slug(heading):
    """The anchor of a heading, as Markdown's renderers make it."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


# Where keys are explained that no table has: those of the file itself, and [code].
EXPLAINED = {"case": ("case-file.md#smallest-case", "Smallest case"), "study": ("studies.md#the-study-file", "The study file"),
             "case.code": ("separation-rules.md#code", "[code]")}


def ways_in(schema, way):
    """The ways of all keys below, "case.building.damping", with what they say; of a key that takes several kinds of
    value those of each."""
    for one in (schema, schema.get("items", {}), *schema.get("anyOf", []), *schema.get("items", {}).get("anyOf", [])):
        for key, below in one.get("properties", {}).items():
            yield f"{way}.{key}", below["x-bentur"]
            yield from ways_in(below, f"{way}.{key}")


def index(texts, schemas):
    """docs/keys.md: each key of the schemas with the tables that explain it, or a key that says the same; where none has
    it, with where the table is that it is, or the key above it is explained. Of a heading what stands before its colon."""
    places = {}  # of a way
    tables = {}  # of a way that is a table
    for document, text in texts.items():
        heading = None
        for line in re.finditer(r"^#+ (.*)$|<!-- keys ([^>]*?) -->", text, re.MULTILINE):
            if line[1]:
                heading = line[1]
                continue
            at = f"{pathlib.Path(document).name}#{slug(heading)}"
            what = line[2].split()
            way = ".".join(("study", *what[1:2])) if what[0] == "study" else f"case.{what[0]}"
            tables.setdefault(way, {})[at] = heading
            for row in keys_table(*table_of(line[2], schemas))[2:]:
                places.setdefault(f"{way}.{row.split('`')[1]}", {})[at] = heading
    tables.update({way: dict([place]) for way, place in EXPLAINED.items()})
    said = dict([*ways_in(schemas["case"], "case"), *ways_in(schemas["study"], "study")])
    explained = [(way.rpartition(".")[2], said[way]) for way in places]
    keys = {}
    for way in (*places, *(way for way in said if way not in places)):
        key, above = way.rpartition(".")[2], way
        if way not in places and (key, said[way]) in explained:
            continue
        while above not in places and above not in tables:
            above = above.rpartition(".")[0]
        keys.setdefault(key, {}).update(places.get(above) or tables[above])
    lines = ["# Keys from A to Z", "", "All keys of case and study files, with the tables that explain them.", ""]
    for key, where in sorted(keys.items()):
        links = ", ".join("[" + heading.partition(":")[0].replace("`", "").replace("[", "\\[").replace("]", "\\]") +
                          f"]({at})" for at, heading in where.items())
        lines.append(f"- `{key}`: {links}")
    return wrapped("\n".join(lines) + "\n")


INDEX = "docs/keys.md"


def texts_of(root):
    return {document: (root / document).read_text() for document in DOCUMENTS}


def schemas_of(program):
    return {what: json.loads(subprocess.run([program, "schema", what], check=True, capture_output=True).stdout)
            for what in ("case", "study")}


def main(program, *documents):
    root = pathlib.Path(__file__).resolve().parents[1]
    schemas = schemas_of(program)
    for document in documents or DOCUMENTS:
        text = (root / document).read_text()
        new = written(text, schemas)
        if new != text:
            (root / document).write_text(new)
            print(f"{document} written anew")
    if not documents:
        (root / INDEX).write_text(index(texts_of(root), schemas))


if __name__ == "__main__":
    main(*sys.argv[1:])
