"""PARI/GP reads what phrame prints for it; the Taylor series of its derivative is that of the integrand.

PARI has no symbolic logarithm, but antiderivative(t) can be given a power series. Where both sides have degree < 24,
48 equal coefficients prove them equal, but for rounding, which is 10^-40 of the largest. The differences of its values
are the integrals.
"""
from fractions import Fraction

import differences
import peers

CHECK = """
{
  my(t = 37/11 + y + O(y^49), F = deriv(antiderivative(t), y), f = integrand(t) + O(y^48), size = 0, error = 0);
  for(k = 0, 47, size = max(size, abs(polcoef(f, k))); error = max(error, abs(polcoef(F, k) - polcoef(f, k))));
  print("%s: ", if(error <= 1e-40 * size, "equal", "different"));
}
"""

DIFFERENCES = """
{
  print("%s: differences");
  my(F = [1.*antiderivative(t) | t <- grid]);
  for(k = 1, #F - 1, my(d = bitprecision(F[k + 1] - F[k], 64)); print(real(d), ";", imag(d)));
}
"""


def run(session):
    return peers.run(["gp", "-q", "-f", "--default", "parisize=64M"], session, "PARI/GP").splitlines()


items = list(peers.scripts("pari"))
output = run("default(realprecision, 300);\n" + "".join(text + CHECK % name for name, text in items))
failures = [name for name, _ in items if f"{name}: equal" not in output]

count = len(items)
items = list(peers.continuous("pari"))
grid = ", ".join(str(Fraction(t)) for t in differences.GRID)
output = run(f"default(realprecision, 100);\ngrid = [{grid}];\n"
             + "".join(text + DIFFERENCES % name for name, text, _ in items))
for name, _, f in items:
    first = output.index(f"{name}: differences") + 1
    lines = output[first:first + len(differences.GRID) - 1]
    values = [complex(*(float(part.replace(" ", "")) for part in line.split(";"))) for line in lines]
    failures += [f"{name}, {jump}" for jump in differences.jumps(f, values)]
peers.finish(count + len(items), failures)
