"""Maxima reads what phrame prints for it; its derivative has the values of the integrand.

Maxima differentiates no lsum over rootsof. With rootsof defined as the roots in 200 digits, the sum is written out.
"""
import shutil
import subprocess

import peers

START = "fpprec: 200$ rootsof(q, z) := map('rhs, bfallroots(q))$\n"
CHECK = """
phrame_variable: first(append(listofvars(integrand), ['x]))$
phrame_derivative: diff(antiderivative, phrame_variable)$
phrame_errors: map(lambda([p], block([f: bfloat(subst(phrame_variable = p, integrand))],
  abs(bfloat(subst(phrame_variable = p, phrame_derivative)) - f)/max(abs(f), 1b-40))), [37/11, -5/7, 11/5])$
print("%s:", if lmax(phrame_errors) < 1b-40 then "equal" else phrame_errors)$
"""

if not shutil.which("maxima"):
    peers.missing("Maxima")
items = [(f"{job.name}, {form}", text) for job in peers.jobs() for form, text in job.scripts("maxima").items()
         if form in job.differentiated]
session = START + "".join(text + CHECK % name for name, text in items)
output = subprocess.run(["maxima", "--very-quiet"], input=session, check=True, capture_output=True, text=True).stdout
output = [line.strip() for line in output.splitlines()]
peers.finish(len(items), [name for name, _ in items if f"{name}: equal" not in output])
