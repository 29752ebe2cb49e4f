"""wheel_licences.py WHEEL: puts the licences of the libraries that auditwheel has put in into the wheel, too."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from wheel._commands.pack import pack
from wheel._commands.unpack import unpack


def package_of(library):
    """The name of the Debian package with this library, libflint-5fa1b2c3.so.17.0.0 in the wheel, or None."""
    name = re.sub(r"-[0-9a-f]{8}(?=\.so)", "", library)
    found = subprocess.run(["dpkg-query", "--search", f"*/{name}"], capture_output=True, text=True, check=False).stdout
    return found.split(":")[0] or None


def main(wheel):
    with tempfile.TemporaryDirectory() as folder:
        unpack(str(wheel), folder)
        (tree,) = Path(folder).iterdir()
        (licences,) = tree.glob("*.dist-info/licenses")
        for library in sorted(path.name for path in tree.glob("*.libs/*")):
            package = package_of(library)
            text = Path(f"/usr/share/doc/{package}/copyright")
            if package is None or not text.exists():
                sys.exit(f"wheel: no licence of {library} found: add it before the wheel is given to others")
            (licences / f"{package}.txt").write_bytes(text.read_bytes())
            print(f"wheel: carries {library}, licence from {package}")
        wheel.unlink()
        pack(str(tree), str(wheel.parent), None)


main(Path(sys.argv[1]).resolve())
