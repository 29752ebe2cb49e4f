"""Computer-algebra systems that are asked for antiderivatives: each a process that is asked one after another, and begun anew when it takes
longer than LIMIT. The time is that of its processor, without start-up and without what prints the answer.

Each is asked by its own function for the purpose, as it comes; Maxima once more with the option that its manual has for denominators that do
not factor.
"""
import os
import re
import select
import shutil
import signal
import subprocess
import sys
import time

LIMIT = 3  # seconds of the processor
PATIENCE = 900  # seconds by the clock, for machines that have other things to do
LONGEST = 400000  # letters of an answer that is kept
END = "@end"


def used(pid):
    """Seconds of the processor, by all threads of a process: its clock, which Linux names so."""
    return time.clock_gettime((~pid << 3) | 2)


class TooLong(Exception):
    pass


class System:
    command, first, prefix = [], "", "@answer "

    def __init__(self):
        self.process = None

    def question(self, f):
        """What is typed, that a line END comes at the end of the work, and prefix with the answer before or after it."""
        raise NotImplementedError

    def begin(self):
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        start_new_session=True, cwd="/tmp")
        os.set_blocking(self.process.stdout.fileno(), False)
        self.process.stdin.write(self.first.encode())
        self.lines("1/(x^2+1)+1/(x-2)^2", 20)

    def stop(self):
        if self.process:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
            self.process = None

    def lines(self, f, limit):
        """(what is printed, the seconds up to END)"""
        pid, text, stop, seconds = self.process.pid, b"", time.monotonic() + PATIENCE, None
        before = used(pid)
        typed = self.question(f).encode()
        out = self.process.stdout
        self.process.stdin.write(typed)
        self.process.stdin.flush()
        while True:
            ready, _, _ = select.select([out], [], [], 0.2)
            if ready:
                more = out.read()
                if more == b"":
                    raise TooLong("the program ended")
                text += more or b""
            if seconds is None and re.search(rb"(?m)^(?:\(\d+\) -> ?|\d+>> )*@work", text):
                seconds = used(pid) - before
            if re.search(rb"(?m)^(?:\(\d+\) -> ?|\d+>> )*@end", text):
                return text.decode(errors="replace"), used(pid) - before if seconds is None else seconds
            if used(pid) - before > (limit if seconds is None else 2 * limit) or time.monotonic() > stop:
                raise TooLong("" if seconds is None else "to print it")

    def answer(self, text):
        """Of what is printed, or None."""
        found = [line.split(self.prefix, 1)[1] for line in text.splitlines() if line.startswith(self.prefix)]
        return found[-1] if found else None

    def ask(self, f):
        """(the answer or None, why there is none, the seconds)"""
        if self.process is None:
            self.begin()
        try:
            text, seconds = self.lines(f, LIMIT)
        except (TooLong, BrokenPipeError) as reason:
            self.stop()
            return None, "time" if str(reason) == "" else str(reason), None
        found = self.answer(text)
        if found and len(found) > LONGEST:
            return None, "%d letters" % len(found), seconds
        return found, "" if found else text[-300:], seconds


class SymPy(System):
    command = [sys.executable, __file__, "--sympy"]

    def version(self):
        import sympy
        return sympy.__version__

    def question(self, f):
        return f + "\n"


def serve_sympy():
    import sympy
    x = sympy.Symbol("x")
    sys.setrecursionlimit(100000)
    for line in sys.stdin:
        f = sympy.sympify(line.strip().replace("^", "**"))
        try:
            answer = sympy.integrate(f, x)
        except Exception as error:
            answer = "integral(%s)" % type(error).__name__
        print("@work", flush=True)
        print("@answer " + str(answer))
        print(END, flush=True)


class Maxima(System):
    command = ["maxima", "--very-quiet"]
    first = "display2d:false$ linel:1000000$\n"

    def version(self):
        return subprocess.run(["maxima", "--version"], capture_output=True, text=True).stdout.split()[-1]

    def question(self, f):
        return "(phrame_r: errcatch(integrate(%s, x)), ?terpri(), ?princ(\"@work\"), ?terpri(), ?finish\\-output())$\n" \
               "(?terpri(), ?princ(\"@answer \"), ?princ(string(first(phrame_r))), ?terpri(), ?princ(\"@end\"), ?terpri(), ?finish\\-output())$\n" % f


class MaximaRoots(Maxima):
    first = Maxima.first + "integrate_use_rootsof:true$\n"


class Giac(System):
    command = ["giac"]

    def version(self):
        found = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "xcas"], capture_output=True, text=True).stdout
        return re.split(r"[+-]", found)[0] or subprocess.run(["giac", "--version"], capture_output=True, text=True).stdout.split("\n")[-2]

    def question(self, f):
        # In lines of their own: what fails takes the rest of its line with it.
        return "phramer:=\"integrate()\":;\nphramer:=integrate(%s,x):;\nprint(\"@work\");\nprint(\"@answer \"+string(phramer));\nprint(\"@end\");\n" % f


class Pari(System):
    command = ["gp", "-q", "-f"]
    first = "default(parisizemax, 4*10^9);\n"

    def version(self):
        return subprocess.run(["gp", "--version-short"], capture_output=True, text=True).stdout.strip()

    def question(self, f):
        return "phramer=iferr(intformal(%s), E, Str(\"integral(\", E, \")\")); print(\"@work\"); print(\"@answer \", phramer); print(\"@end\")\n" % f


class FriCAS(System):
    """The antiderivative has roots inside roots; they are named from the outermost, as a whole they would be too long to print."""
    command = ["fricas", "-nosman"]
    file = "/tmp/phrame-audit-fricas-%d" % os.getpid()
    first = """)set messages time off
)set messages type off
)set messages autoload off
)set output algebra off
EI ==> Expression(Integer)
"""

    def version(self):
        text = subprocess.run(["fricas", "-nosman"], input=")quit\n", capture_output=True, text=True).stdout
        return re.search(r"Version: FriCAS (\S+)", text)[1]

    def question(self, f):
        return """phrameR : Union(EI, List EI) := ('integral)::EI
phrameF : Fraction(Polynomial(Integer)) := %s
phrameR : Union(EI, List EI) := integrate(phrameF, x)
)lisp (progn (format t "~%%@work~%%") (finish-output))
phrameE : EI := phrameR :: EI
phrameK := reverse [k1 for k1 in tower(phrameE) | is?(k1, 'rootOf)]
phrameT : TextFile := open("%s", "output")
phrameM : List EI := []
phrameS := [(concat("root", string(i1)))::Symbol::EI for i1 in 1..#phrameK]
for k1 in phrameK for s1 in phrameS repeat (phrameM := concat([eval(m1, k1, s1) for m1 in phrameM], elt(minPoly(k1)$EI, s1)); phrameE := eval(phrameE, k1, s1))
for m1 in phrameM repeat writeLine!(phrameT, unparse(m1::InputForm))
writeLine!(phrameT, unparse(phrameE::InputForm))
close!(phrameT)
)lisp (progn (format t "~%%@end~%%") (finish-output))
""" % (f, self.file)

    def ask(self, f):
        if os.path.exists(self.file):
            os.remove(self.file)
        return super().ask(f)

    def answer(self, text):
        try:
            with open(self.file) as file:
                *roots, answer = file.read().splitlines()
            os.remove(self.file)
        except (OSError, ValueError):
            return None
        return " ; ".join([answer, *roots])


class Phrame(System):
    """Which is here to be compared with the others, by what it prints for Maxima; each time a process of its own."""

    def version(self):
        return subprocess.run([os.environ["PHRAME_PROGRAM"], "--version"], capture_output=True, text=True).stdout.split()[-1]

    def ask(self, f):
        import resource
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            run = subprocess.run([os.environ["PHRAME_PROGRAM"], "integrate", "--print", "maxima", "--", f], capture_output=True, text=True,
                                 timeout=PATIENCE)
        except subprocess.TimeoutExpired:
            return None, "time", None
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        if run.returncode:
            return None, run.stderr.strip(), seconds
        lines = [line.split(": ", 1)[1].rstrip("$") for line in run.stdout.splitlines() if line.startswith("antiderivative: ")]
        return lines[0], "", seconds


SYSTEMS = {"phrame": Phrame, "sympy": SymPy, "maxima": Maxima, "maxima-rootsof": MaximaRoots, "fricas": FriCAS, "giac": Giac, "pari": Pari}
PROGRAMS = {"sympy": sys.executable, "maxima": "maxima", "maxima-rootsof": "maxima", "fricas": "fricas", "giac": "giac", "pari": "gp"}


def is_there(name):
    return name not in PROGRAMS or shutil.which(PROGRAMS[name]) is not None


if __name__ == "__main__":
    serve_sympy()
