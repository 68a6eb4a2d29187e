"""key_tables.py PROGRAM [DOCUMENT...]: writes the tables of keys in the documents from the schemas of PROGRAM, bentur.

A table stands between two comments. `<!-- keys building.frame -->` is of the keys of a table; with `kind=record` after
it of those that are for that word of `kind` alone, with `kind=` of those that are for all, with `law` of those that are
for some. `<!-- words gap.contact law -->` is of the words of a key and what each needs. A way that begins with `study`
is into a study. tests/python/keys_test.py finds tables that are not as they would be written.
"""

import json
import pathlib
import re
import subprocess
import sys

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
    by, equals, word = choice.partition("=")
    rows = {}
    for key, schema in properties.items():
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


def written(text, schemas):
    def block(found):
        head, kind, what, _, tail = found.groups()
        way, _, choice = what.partition(" ")
        schema = schemas["case"]
        if way == "study":
            schema, (way, _, choice) = schemas["study"], choice.partition(" ")
        properties = table_at(schema, way)
        lines = words_table(properties, choice) if kind == "words" else keys_table(properties, choice)
        return head + "\n".join(lines) + "\n" + tail

    return BLOCK.sub(block, text)


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


if __name__ == "__main__":
    main(*sys.argv[1:])
