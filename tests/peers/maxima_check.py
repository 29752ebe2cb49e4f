"""Maxima reads what phrame prints for it; its derivative has the values of the integrand.

Maxima differentiates no lsum over rootsof. With rootsof defined as the roots in 60 digits, the sum is written out.
"""
import peers

START = "fpprec: 60$ rootsof(q, z) := map('rhs, bfallroots(q))$\n"
CHECK = """
phrame_error: lmax(map(lambda([p], abs(bfloat(subst(x = p, diff(antiderivative, x) - integrand)))), [37/11, -5/7, 11/5]))$
print("%s:", if phrame_error < 1b-40 then "equal" else phrame_error)$
"""


def in_x(text):
    """The scripts use different variables; the check is written for x."""
    variable = next((v for v in "uwtz" if f"{v}^2" in text.splitlines()[0] or f"{v} " in text.splitlines()[0]), "x")
    return text + f"antiderivative: subst({variable} = x, antiderivative)$ integrand: subst({variable} = x, integrand)$\n"


items = list(peers.scripts("maxima"))
session = START + "".join(in_x(text) + CHECK % name for name, text in items)
output = [line.strip() for line in peers.run(["maxima", "--very-quiet"], session, "Maxima").splitlines()]
peers.finish(len(items), [name for name, _ in items if f"{name}: equal" not in output])
