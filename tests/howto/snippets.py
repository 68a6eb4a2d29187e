"""snippets.py OUTPUT PAGE...: a source in which every piece of C++ that the pages show has to compile.

Pieces are what stands between backticks and begins with a designator, `{.speed = 1}` or `.linear = false`, each of which
has to initialise one of the structs that a law deals in, and whole fenced blocks of cpp, each the body of a function.
"""

import pathlib
import re
import sys

HEAD = """// Made by tests/howto/snippets.py from the pages of docs/howto.
#include "bentur/elements/law.h"
#include "bentur/pounding/pounding.h"
#include "bentur/structure/damping.h"
#include "docs/howto/base_moment.h"
#include "docs/howto/tank.h"
#include "bentur/pounding/assemble.h"

namespace bentur {

template <typename Struct>
concept Known = std::same_as<Struct, Guard> || std::same_as<Struct, Branch> || std::same_as<Struct, LawState>;
"""


def main():
    output, *pages = map(pathlib.Path, sys.argv[1:])
    text, count = HEAD.replace("#include", "#include <concepts>\n#include <stdexcept>\n\n#include", 1), 0
    for page in pages:
        for number, line in enumerate(page.read_text().splitlines(), 1):
            for piece in re.findall(r"`(\{?\.\w+ = [^`]*)`", line):
                count += 1
                values = piece if piece.startswith("{") else "{" + piece + "}"
                text += f"""
// {page.name}:{number}
template <typename T>
concept Snippet{count} = Known<T> && requires(double extreme, double time) {{ T{values}; }};
static_assert(Snippet{count}<Guard> || Snippet{count}<Branch> || Snippet{count}<LawState>, {'R"(' + piece + ')"'});
"""
        for block in re.findall(r"```cpp\n(.*?)```", page.read_text(), re.DOTALL):
            count += 1
            text += f"\n// {page.name}\n[[maybe_unused]] void snippet_{count}() {{\n{block}}}\n"
    if count == 0:
        sys.exit("the pages have no C++")
    output.write_text(text + "\n}  // namespace bentur\n")


main()
