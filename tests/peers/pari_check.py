"""PARI/GP reads what phrame prints for it; the Taylor series of its derivative is that of the integrand.

PARI has no symbolic logarithm, but antiderivative(t) can be given a power series. Where both sides have degree < 24,
48 equal coefficients prove them equal, but for rounding, which is 10^-40 of the largest. The differences of its values
are the integrals.
"""
import atexit
import functools
import json
import os
import re
import subprocess
from fractions import Fraction

import differences
import peers

# The roots of a polynomial once, not at each point.
START = f"""
integrand = antiderivative = 0;
known = Map();
roots(q) =
{{
  my(z, key = [q, default(realprecision)]);
  if(!mapisdefined(known, key, &z), z = polroots(q); mapput(known, key, z));
  z;
}}
grid = [{", ".join(str(Fraction(t)) for t in differences.GRID)}];
"""

DERIVES = """
default(realprecision, 300);
{
  my(t = 37/11 + y + O(y^49), F = deriv(antiderivative(t), y), f = integrand(t) + O(y^48), size = 0, error = 0);
  for(k = 0, 47, size = max(size, abs(polcoef(f, k))); error = max(error, abs(polcoef(F, k) - polcoef(f, k))));
  print(if(error <= 1e-40 * size, "equal", "different"));
}
"""

DIFFERENCES = """
default(realprecision, %d);
{
  my(F = [1.*antiderivative(t) | t <- grid]);
  for(k = 1, #F - 1, my(d = bitprecision(F[k + 1] - F[k], 64)); print(real(d), ";", imag(d)));
}
"""


@functools.cache
def gp(_):
    """The one gp of a process, known by its number."""
    try:
        process = subprocess.Popen(["gp", "-q", "-f", "--default", "parisizemax=1G"], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, text=True)
    except FileNotFoundError:
        peers.missing("PARI/GP")
    atexit.register(process.communicate)
    process.stdin.write(START)
    return process


def answer(process, text):
    """The lines it prints. What an earlier text has defined is gone, should this one not be read."""
    process.stdin.write("kill(integrand); kill(antiderivative);\n" + text + 'print("done");\n')
    process.stdin.flush()
    lines = []
    for line in process.stdout:
        if line == "done\n":
            return lines
        lines.append(line.rstrip())
    raise BrokenPipeError("gp has ended")


def run(text):
    """answer() of this process's gp. After minutes of long polynomials a gp has been seen to end; a new one is asked then."""
    try:
        try:
            return answer(gp(os.getpid()), text)
        except BrokenPipeError:
            gp.cache_clear()
            return answer(gp(os.getpid()), text)
    except peers.TooLong:
        gp(os.getpid()).kill()
        gp.cache_clear()
        raise


def derives(text):
    return run(text + DERIVES) == ["equal"]


def evaluate(text, digits):
    """Numbers are rounded when they are divided, for to reduce long fractions at each point takes hours."""
    text = re.sub(r"\((\d+)/(\d+)\)", r"(\1./\2)", text.replace("polroots(", "roots("))
    lines = run(text + DIFFERENCES % digits)
    return [complex(*(float(part.replace(" ", "")) for part in line.split(";"))) for line in lines]


TURN = """
{
  my(d = antiderivative(1.) - antiderivative(0.));
  print(default(realprecision), ";", real(d), ";", imag(d));
}
"""
PRECISION = r"if\(default\(realprecision\) < (\d+), default\(realprecision, \1\)\);\n"


def turn(text):
    """antiderivative(1) − antiderivative(0) by a script and nothing else, and the digits that gp computed with."""
    digits, *parts = run("default(realprecision, 38);\n" + text + TURN)[-1].split(";")
    return int(digits), [Fraction(part.replace(" ", "").replace("E", "e")) for part in parts]


def imprecise():
    """Scripts with too few digits for the turn of the angle from 0 to 1, which `phrame angle --at` prints proved.

    20 are to be right. The first curve needs more than gp has by default, and so says the script."""
    curves = {curve["name"]: json.dumps(curve) for curve in peers.read("curves.jsonl")}
    long = "gen-m20-0"
    for name in [long] + sorted(set(curves) - {long} if peers.IS_CORPUS else ["gen-m04-0"]):
        for frame in ["erf", "frenet"]:
            job = peers.Job(name, ["angle", "--frame", frame, "-"], curves[name])
            text = job.print_for("pari")
            if not text:
                continue
            values = peers.Job(name, job.arguments + ["--at", "0,1", "--digits", "25"], job.text).print_for("json")
            start, end = (Fraction(value["theta"]) for value in json.loads(values)["values"])

            def is_right(script):
                digits, (real, imaginary) = turn(script)
                wanted = re.search(PRECISION, script)
                error = max(abs(real - (end - start)), abs(imaginary)) / max(1, abs(end - start))
                return error < Fraction(1, 10**19) and digits >= int(wanted[1] if wanted else 38)  # gp takes whole words

            if not is_right(text):
                yield f"{name}, {frame}: F(1) - F(0) is wrong"
            without = re.sub(PRECISION, "", text)
            if name == long and frame == "frenet" and (without == text or is_right(without)):
                yield f"{name}, {frame}: no precision is set, or none is needed"


peers.main("pari", derives, evaluate, imprecise)
