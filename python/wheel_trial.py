"""Run where there is Python with the wheel and NumPy, installed or beside this file, and nothing else."""

import os
import sys
import tempfile
from fractions import Fraction

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, here)

import numpy as np  # noqa: E402
import phrame  # noqa: E402
import quickstart  # noqa: E402

# The curve of Farouki (2003), section 4. Its angle by mpmath: minus twice the integral of h/σ, to 50 digits.
curve = phrame.Curve([2, -4, 4], [1, 0, -1], [0, -4, 4], [1, 2, -2])
theta = curve.angle().value(1)
assert str(theta.digits(50)) == "0.28585653009834106200165626280309220136381867044677"
assert curve.length == Fraction(71, 15)

ts = np.linspace(0, 1, 100000)  # enough for several threads
frames = curve.frames(ts)
assert np.allclose(frames @ frames.transpose(0, 2, 1), np.eye(3), atol=1e-15)
path = phrame.Curve.through([[0, 0, 0], [1, 0.5, 0], [2, 0, 1], [3, 1, 1]], kind="c2")
assert np.allclose(path.points([0.0, 3.0]), [[0, 0, 0], [3, 1, 1]], atol=1e-6)
try:
    phrame.Curve([1, "1/0"], [0], [0], [0])
except phrame.InputError as error:
    assert error.place
else:
    raise AssertionError("1/0 is accepted")
assert len(phrame.reference()) > 300 and phrame.reference("plane")[0].path.name == "plane-01"
quickstart.main()

with tempfile.TemporaryDirectory() as folder:
    page = os.path.join(folder, "curve.html")
    curve.page(page)  # which needs npm when the wheel is made, and nothing here
    with open(page, encoding="utf-8") as file:
        html = file.read()
assert html.startswith("<!doctype html>") and "katex" in html and len(html) > 500_000, html[:200]

# In an empty root no /proc is mounted, and there is nothing else to be loaded.
if os.path.exists("/proc/self/maps"):
    with open("/proc/self/maps") as maps:
        loaded = {line.split()[-1] for line in maps if ".so" in line}
    installed = os.path.dirname(os.path.dirname(os.path.realpath(phrame.__file__)))
    for name in ("libflint", "libmpfr", "libgmp", "libnlopt", "libfmt"):
        strangers = [path for path in loaded if name in os.path.basename(path) and not path.startswith(installed)]
        assert not strangers, strangers
print("phrame", phrame.__version__, "works in CPython", sys.version.split()[0], "with NumPy", np.__version__)
