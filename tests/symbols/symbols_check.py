"""symbols_check.py LIBRARY COMPILER [--write]

Compares what a shared phrame shows with phrame.txt beside this: functions and constants of the namespace phrame, and the
classes that are thrown. A static library is linked to a shared one for it. With --write the list becomes what it shows.
"""
import difflib
import pathlib
import re
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("phrame.txt")


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


def main(library, compiler, *options):
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
