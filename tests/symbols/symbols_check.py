"""symbols_check.py LIBRARY COMPILER [--write]

Is all marked PHRAME_API that public headers declare and the library defines? Then what a shared phrame shows is compared
with phrame.txt beside this: functions and constants of the namespace phrame, and the classes that are thrown. A static
library is linked to a shared one for it. With --write the list becomes what it shows.
"""
import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("phrame.txt")
SOURCES = pathlib.Path(__file__).parents[2] / "src"


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def shared(library, compiler, folder):
    if library.endswith(".so") or ".so." in library:
        return library
    made = f"{folder}/phrame.so"
    run(compiler, "-shared", "-nodefaultlibs", "-Wl,--whole-archive", library, "-Wl,--no-whole-archive", "-o", made)
    return made


def readable(name):
    """As it is declared: without what nobody writes, as defaults of templates, nor the inline namespace of the version."""
    name = re.sub(r"\bphrame::(v\d\w*::)?", "", name)
    name = name.replace("std::__cxx11::", "std::").replace("[abi:cxx11]", "").replace("> >", ">>").replace("> >", ">>")
    name = name.replace("std::basic_string<char, std::char_traits<char>, std::allocator<char>>", "std::string")
    name = name.replace("std::basic_string_view<char, std::char_traits<char>>", "std::string_view")
    name = name.replace("std::basic_ostream<char, std::char_traits<char>>", "std::ostream")
    start = name.find(", std::allocator<")  # the last argument of a container
    while start >= 0:
        end, depth = name.index("<", start) + 1, 1
        while depth:
            depth += {"<": 1, ">": -1}.get(name[end], 0)
            end += 1
        name = name[:start] + name[end:].lstrip(" ")
        start = name.find(", std::allocator<")
    name = re.sub(r"std::array<(\w+), 3ul>", r"Vector<\1>", name)
    return re.sub(r"\b(\d+)ul\b", r"\1", name)


def symbols(library):
    found = set()
    for line in run("nm", "--dynamic", "--defined-only", "--demangle", library).splitlines():
        kind, name = line.split(maxsplit=2)[1:]
        # Not what is weak: of templates and inline functions some are there, by one compiler, and some not.
        if kind in "TDBR" and name.startswith("phrame::") or re.match(r"typeinfo for phrame::(v\d\w*::)?\w+$", name):
            found.add(readable(name))
    return found


def public_headers():
    """The text of each, by its name, without comments."""
    found, todo = {}, ["phrame.hpp", "algebra/multiprecision.hpp"]
    while todo:
        name = todo.pop()
        if name in found or not (SOURCES / name).exists():
            continue
        found[name] = re.sub(r" *//.*", "", (SOURCES / name).read_text())
        todo += re.findall(r'^#include "phrame/(.*)"', found[name], re.M)
    return found


def unmarked(text):
    """What is declared here without a body and without PHRAME_API, as clang-format writes it."""
    text = re.sub(r" = [^,;(){}]*(\(\)|\{\})?(?=[,)])", "", text)  # default arguments
    text = re.sub(r"^template [^;{]*[;{]", "", text, flags=re.M)
    functions = re.findall(r"^(?!PHRAME_API|inline|constexpr|using|namespace|class|struct|enum|extern|static_assert|#|PHRAME_C_TYPE)"
                           r"((?:\[\[noreturn\]\] (?!PHRAME_API))?\w[^;{}#]*\));", text, re.M)
    for kind, name, body in re.findall(r"^(class|struct) (?!PHRAME_API)(\w+)[^;{]*\{(.*?)^\};", text, re.M | re.S):
        if re.search(r"^  (?! |friend|using)[\w~:\[][^;{}=]*\)( const)?( noexcept)?( override)?;", body, re.M):
            functions.append(f"{kind} {name}")
    return functions


def main(library, compiler, *options):
    missing = [f"src/{header}: {' '.join(what.split())}" for header, text in sorted(public_headers().items())
               for what in unmarked(text)]
    if missing:
        print(*missing, sep="\n")
        sys.exit("These are public, and not marked PHRAME_API (docs/architecture.md).")
    with tempfile.TemporaryDirectory() as folder:
        found = sorted(symbols(shared(library, compiler, folder)))
    if "--write" in options:
        LIST.write_text("".join(f"{name}\n" for name in found))
        return
    listed = LIST.read_text().splitlines()
    if found == listed:
        return
    for line in difflib.unified_diff(listed, found, "listed", "shown", lineterm="", n=0):
        print(line)
    sys.exit("A shared phrame shows other symbols than tests/symbols/phrame.txt says. Are they to be public, or gone?\n"
             f"Then: python3 {sys.argv[0]} {library} {compiler} --write")


main(*sys.argv[1:])
