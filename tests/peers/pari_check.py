"""PARI/GP reads what phrame prints for it; the Taylor series of its derivative is that of the integrand.

PARI has no symbolic logarithm, but antiderivative(t) can be given a power series. Where both sides have degree < 24,
48 equal coefficients prove them equal, but for rounding, which is 10^-40 of the largest.
"""
import peers

CHECK = """
{
  my(t = 37/11 + y + O(y^49), F = deriv(antiderivative(t), y), f = integrand(t) + O(y^48), size = 0, error = 0);
  for(k = 0, 47, size = max(size, abs(polcoef(f, k))); error = max(error, abs(polcoef(F, k) - polcoef(f, k))));
  print("%s: ", if(error <= 1e-40 * size, "equal", "different"));
}
"""

items = list(peers.scripts("pari"))
session = "default(realprecision, 300);\n" + "".join(text + CHECK % name for name, text in items)
output = peers.run(["gp", "-q", "-f", "--default", "parisize=64M"], session, "PARI/GP").splitlines()
peers.finish(len(items), [name for name, _ in items if f"{name}: equal" not in output])
