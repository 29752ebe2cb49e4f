"""tools/audit, integrals: the functions are those of the log, the tables of docs/audit.md are those of the log, and the judge tells an
antiderivative that is right from one that jumps, one that is wrong, and none, in the notations of all the systems.
"""
import json
import sys
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/audit"))
try:
    import functions
    import judge
except ImportError:
    print("python-flint is not installed")
    sys.exit(77)
import integrals

RIOBOO = "(x^4-3*x^2+6)/(x^6-5*x^4+5*x^2+4)"
# Bronstein, Symbolic Integration I, section 2.8, has both answers to Rioboo's example; that of one arctangent jumps at +-sqrt(2).
ANSWERS = [
    (RIOBOO, "atan(x)+atan(x^3)+atan((x^5-3*x^3+x)/2)", "right"),
    (RIOBOO, "atan((x^3-3*x)/(x^2-2))", "jump"),
    (RIOBOO, "atan(x)+atan(x^3)-atan((x^5-3*x^3+x)/2)", "wrong"),
    ("-2*x/(x^4-2*x^2+2)", "atan(1/(x^2-1))", "jump"),  # there and back, so that the ends do not show it
    (RIOBOO, "'integrate((x^4-3*x^2+6)/(x^6-5*x^4+5*x^2+4),x)", "none"),
    (RIOBOO, "RootSum(4*_t**2 + 1, Lambda(_t, _t*log(2*_t*x**2 - 4*_t + x**3 - 3*x)))", "jump"),
    ("1/(x^3-2)", "'lsum(%r1*log(x-%r1)/6,%r1,rootsof(%r1^3-2,%r1))", "right"),
    ("1/(x^3-2)", "'lsum(%r1*log(x-%r1)/5,%r1,rootsof(%r1^3-2,%r1))", "wrong"),
    ("1/(x^3-2)", "root2*log(x-root2)/6+root1*log(x-root1)/6+(-(root1+root2))*log(x+root1+root2)/6 ; (3*root1^2+3*root2*root1+3*root2^2)/3 ; root2^3-2", "right"),
    ("2/(x^2-2)", "1/2*ln(abs((x-sqrt(2))/(x+sqrt(2))))*sqrt(2)", "right"),
    ("1/(x^2-2)^2", "-x/(4*(x^2-2))", "wrong"),
    ("1/(10^22*x^2+1)", "atan(10^11*x)/10^11", "right"),
    ("1/(10^22*x^2+1)", "atan(10^11*x)/10^11*(1+1/10^15)", "wrong"),
    ("1/(x^2+1)", "1.0*atan(x)", "none")]


def main():
    log = json.loads(integrals.LOG.read_text())
    rows = functions.functions()
    problems = []
    if len({f for _, _, f in rows}) != functions.COUNT or functions.digest() != log["digest"]:
        problems.append("the functions are not those of the log")
    if [label for label, _, _ in rows] != list(log["functions"]):
        problems.append("the log has other functions")
    for f, answer, word in ANSWERS:
        found = judge.judged(judge.Rational(f), answer)
        if found[0] != word:
            problems.append("%s of %s: %s" % (answer, f, found))
    page = integrals.PAGE.read_text()
    for mark, table in integrals.rendered(log).items():
        if "<!-- %s -->\n%s\n<!-- end -->" % (mark, table) not in page:
            problems.append("docs/audit.md has another table %s than its log" % mark)
    print("%d functions, %d answers judged" % (len(rows), len(ANSWERS)))
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
