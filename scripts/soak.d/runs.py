"""Runs autocuts-cli under limits and says what it did that it must not do."""
import json
import os
import re
import resource
import signal
import subprocess
import time
from collections import Counter
from dataclasses import dataclass

EXIT_CODES = {0, 1, 2, 3, 130}
CPU_SECONDS = 20
WALL_SECONDS = 300  # for programs that wait for ever; the machine may be busy
MEMORY_MIB = 1500
INPUT_FAILED = "autocuts-cli: failed: "
# A function's name before a colon, as in "measureUv: ..." or "std::bad_alloc".
FUNCTION_NAME = re.compile(r"(^|[\s(])[a-z]+[A-Z]\w*(\(\))?: |\w::\w")


@dataclass
class Run:
    code: int  # negative: ended by that signal
    out: str
    err: str
    cpu: float
    memory: float  # MiB
    late: float = 0.0  # seconds from the signal to the end
    late_cpu: float = 0.0  # CPU seconds in that time


class Program:
    def __init__(self, path, sanitized):
        self.path, self.folder = path, None
        self.slowness = 20 if sanitized else 1
        self.sanitized = sanitized
        self.codes = Counter()  # runs by command and exit code
        self.environment = dict(os.environ, ASAN_OPTIONS="exitcode=99:allocator_may_return_null=1",
                                UBSAN_OPTIONS="halt_on_error=1:exitcode=99", OMP_NUM_THREADS="1")

    def limits(self, file_size):
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        cpu = CPU_SECONDS * self.slowness
        resource.setrlimit(resource.RLIMIT_CPU, (cpu, cpu + 5))
        if not self.sanitized:
            resource.setrlimit(resource.RLIMIT_AS, (4 * MEMORY_MIB << 20, 4 * MEMORY_MIB << 20))
        if file_size is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))

    def run(self, arguments, file_size=None, send=None, after=0.0, out=None, more=None):
        """\\param send a signal, sent that many seconds after the start, once the program is ready for it
        \\param more environment variables"""
        names = [os.path.join(self.folder, n) for n in ("stdout", "stderr")]
        with open(out or names[0], "wb") as o, open(names[1], "wb") as e:
            process = subprocess.Popen([self.path, *arguments], stdin=subprocess.DEVNULL, stdout=o, stderr=e,
                                       cwd=self.folder, env={**self.environment, **(more or {})},
                                       preexec_fn=lambda: self.limits(file_size))
            start, sent, sent_cpu, status = time.monotonic(), None, 0.0, None
            while status is None:
                done, raw, usage = os.wait4(process.pid, os.WNOHANG)
                now = time.monotonic()
                if done:
                    status = os.waitstatus_to_exitcode(raw)
                    process.returncode = status
                elif send and sent is None and now - start >= after and ready(process.pid, send):
                    sent, sent_cpu = now, cpu_of(process.pid)
                    os.kill(process.pid, send)
                elif now - start > WALL_SECONDS * self.slowness:
                    os.kill(process.pid, signal.SIGKILL)
                if status is None:
                    time.sleep(0.001)
        texts = [open(n, "rb").read().decode("utf-8", "replace") for n in names]
        cpu = usage.ru_utime + usage.ru_stime
        self.codes[arguments[0], status] += 1
        run = Run(status, "" if out else texts[0], texts[1], cpu, usage.ru_maxrss / 1024)
        if sent is not None:
            run.late, run.late_cpu = now - sent, cpu - sent_cpu
        return run

    def faults(self, run):
        """What is wrong with any run of the program, in words that are equal for equal causes."""
        faults = []
        if run.code == -signal.SIGXCPU or run.code == -signal.SIGKILL:
            faults.append("takes more than %d CPU seconds" % (CPU_SECONDS * self.slowness))
        elif run.code < 0:
            faults.append("ended by signal %d" % -run.code)
        elif run.code not in EXIT_CODES:
            faults.append("exit code %d" % run.code)
        if not self.sanitized and run.memory > MEMORY_MIB:
            faults.append("takes more than %d MiB" % MEMORY_MIB)
        if FUNCTION_NAME.search(run.err):
            faults.append("names a function on stderr")
        lines = [x for x in run.err.splitlines() if x.strip()]
        if run.code in (1, 2):
            errors = [x for x in lines if x.startswith("autocuts-cli: ") and not
                      x.startswith(("autocuts-cli: note:", "autocuts-cli: warning:"))]
            # Of several inputs each one that fails has a line.
            errors += [x for x in lines if x.startswith("{") and '"status":"failed"' in x]  # --progress json
            of_inputs = {x for x in errors if x.startswith((INPUT_FAILED, "{"))}
            differs = run.code == 1 and "the result differs" in run.out
            if len(errors) != 1 and len(of_inputs) != max(1, len(errors)) and not differs:
                faults.append("fails with %d error lines" % len(errors))
        return faults

    def flipped_in(self, path):
        """The flipped triangles of the map of a file."""
        run = self.run(["check", path, "--json"])
        try:
            return json.loads(run.out)["flipped"]
        except (ValueError, KeyError):
            return 0

    def map_faults(self, path, without_overlaps, session=None):
        """What is wrong with a map that a job has written with success. Islands that a session locks keep their flips."""
        run = self.run(["check", path, "--json"])
        faults = ["check of the result: " + f for f in self.faults(run)]
        if run.code != 0:
            return faults + ["check of the result: exit code %d" % run.code]
        try:
            figures = json.loads(run.out)
        except ValueError:
            return faults + ["check --json writes no JSON"]
        if figures["flipped"] and not (session and figures["flipped"] <= self.flipped_in(session)):
            faults.append("flipped triangles in the result")
        if figures["faces_without_uv"]:
            faults.append("faces without UVs in the result")
        if without_overlaps and figures["overlap_pairs"]:
            faults.append("overlaps in the result")
        return faults


def cpu_of(pid):
    fields = open("/proc/%d/stat" % pid).read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def ready(pid, number):
    """True when the program catches the signal, or cannot."""
    if number == signal.SIGKILL:
        return True
    for line in open("/proc/%d/status" % pid):
        if line.startswith("SigCgt:"):
            return int(line.split()[1], 16) >> (number - 1) & 1 == 1
    return False
