"""Many files on many machines: what ``autocuts-cli batch`` does, by Dask.

    python3 -m autocuts.farm unwrap --scheduler tcp://head:8786 models -o mapped --report night.html

The options are those of ``autocuts-cli batch``, and those of farm_options() below. Journal and report are written by
``autocuts-cli``, here; each file is a batch of its own on a worker.
"""

import argparse
import asyncio
import collections
import concurrent.futures
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

IN_FLIGHT = 4096  # files that the scheduler knows of at once
SENT_IN_FLIGHT = 2**28  # bytes of them, when they are sent along
CONNECTING = 10  # seconds that a client tries to reach its scheduler; the pauses between its tries grow with them


def put(path, content):
    """Writes a file so that it is there whole or not at all."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    handle, made = tempfile.mkstemp(prefix=".autocuts-", dir=os.path.dirname(path))
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        mask = os.umask(0)
        os.umask(mask)
        os.chmod(made, 0o666 & ~mask)
        os.replace(made, path)
    except BaseException:
        os.remove(made)
        raise


def read(path):
    with open(path, "rb") as file:
        return file.read()


def files_below(folder):
    for place, _, names in os.walk(folder):
        for name in names:
            yield os.path.relpath(os.path.join(place, name), folder)


def work(job):
    """Runs on a worker: works on a file, and returns the line for the journal and the files to bring back."""
    from distributed import get_worker

    program = os.environ.get("AUTOCUTS_CLI", "autocuts-cli")
    with tempfile.TemporaryDirectory(prefix="autocuts-") as scratch:
        is_sent = job["sent"] is not None
        root = os.path.join(scratch, "files") if is_sent else job["root"]
        for path, content in (job["sent"] or {}).items():
            put(os.path.join(root, path), content)
        source, folder = os.path.join(root, job["source"]), os.path.join(root, job["folder"])
        target = os.path.dirname(os.path.join(folder, job["output"]))
        notes = os.path.join(scratch, "notes")
        threads = get_worker().state.nthreads
        command = [program, *job["arguments"], "--jobs", str(threads), "--journal", notes, "-o", target, "--quiet"]
        if job["pictures"]:
            command += ["--report", os.path.join(scratch, "report.html")]
        ran = subprocess.run([*command, "--", source], cwd=scratch if is_sent else job["cwd"],
                             stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        try:
            head, line = (json.loads(text) for text in read(os.path.join(notes, "autocuts-batch.jsonl")).splitlines())
        except (OSError, ValueError):
            raise RuntimeError(ran.stderr.strip() or f"exit code {ran.returncode}") from None
        if head["autocuts"] != job["autocuts"]:
            raise RuntimeError(f"the worker has version {head['autocuts']} of autocuts-cli, not {job['autocuts']}")
        line["output"] = job["output"]
        line["message"] = line["message"].replace(source, job["input"])
        line["warnings"] = [warning.replace(source, job["input"]) for warning in line["warnings"]]
        back = {}
        if is_sent:
            back = {path: read(os.path.join(folder, path)) for path in files_below(folder)}
        pictures = {os.path.join(job["pictures"], job["picture"]): read(os.path.join(notes, ".autocuts-batch", name))
                    for name in files_below(os.path.join(notes, ".autocuts-batch"))}
        if not is_sent:
            for path, content in pictures.items():
                put(os.path.join(root, path), content)
            pictures = {}
        return line, back, pictures


class Plan:
    """What is to be done, as ``autocuts-cli`` says, which is told of each result."""

    def __init__(self, arguments, sends):
        program = os.environ.get("AUTOCUTS_CLI") or shutil.which("autocuts-cli")
        if not program:
            sys.exit("autocuts.farm: autocuts-cli was not found. Install it, or set AUTOCUTS_CLI to its path")
        self.process = subprocess.Popen([program, "batch", *arguments, "--elsewhere"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True)
        first = self.process.stdout.readline()
        if not first.startswith('{"'):  # it has no work to give: --help, a mistake
            sys.stdout.write(first + self.process.stdout.read())
            sys.exit(self.process.wait())
        self.head = json.loads(first)
        self.tasks = [json.loads(self.process.stdout.readline()) for _ in range(self.head["files"])]
        self.folder = os.path.abspath(self.head["folder"])
        self.sends = sends
        places = [self.folder, *(os.path.dirname(os.path.abspath(task["input"])) for task in self.tasks)]
        self.root = os.path.commonpath(places + [os.path.abspath(self.head["pictures"])])

    def below(self, path):
        return os.path.relpath(os.path.abspath(path), self.root)

    def job(self, task):
        source = os.path.abspath(task["input"])
        sent = None
        if self.sends:
            stem, place = os.path.basename(source).split(".")[0] + ".", os.path.dirname(source)
            sent = {self.below(os.path.join(place, name)): read(os.path.join(place, name))
                    for name in os.listdir(place) if name.startswith(stem) and os.path.isfile(os.path.join(place, name))}
        return {"autocuts": self.head["autocuts"], "arguments": self.head["arguments"], "cwd": os.getcwd(),
                "root": self.root, "folder": self.below(self.folder), "source": self.below(source), "sent": sent,
                "input": task["input"], "output": task["output"], "picture": task["picture"],
                "pictures": self.head["pictures"] and self.below(self.head["pictures"])}

    def note(self, line):
        self.process.stdin.write(json.dumps(line) + "\n")
        self.process.stdin.flush()

    def finish(self):
        """Lets the report and the summary be written. Returns the exit code of the batch."""
        self.process.stdin.close()
        sys.stdout.write(self.process.stdout.read())
        return self.process.wait()


class Farm:
    """Gives the files of a plan to a scheduler, and to the next one when that is lost."""

    def __init__(self, plan, connect, choice):
        self.plan, self.connect, self.choice = plan, connect, choice
        self.waiting = collections.deque(plan.tasks)
        self.bytes = 0

    def run(self):
        while self.waiting:
            with self.connect() as client:
                # A client connects again by itself. It must not be closed while it does: Dask may wait for ever then.
                while client.status == "connecting" or (self.waiting and client.status == "running"):
                    self.serve(client)
                    time.sleep(0.1)

    def serve(self, client):
        """Until all is done, or the scheduler is lost, and with it what it had."""
        from distributed import as_completed

        running, finished = {}, as_completed()

        def give():
            while self.waiting and len(running) < IN_FLIGHT and self.bytes < SENT_IN_FLIGHT and client.status == "running":
                task = self.waiting[0]
                job = self.plan.job(task)
                future = client.sync(self.submit, client, job, task)
                if not future:
                    return
                self.waiting.popleft()
                size = sum(len(content) for content in (job["sent"] or {}).values())
                running[future] = task, size
                self.bytes += size
                finished.add(future)

        give()
        for future in finished:
            task, size = running.pop(future)
            self.bytes -= size
            if self.note(task, future):
                give()
            else:
                self.waiting.append(task)

    async def submit(self, client, job, task):
        """Runs in the client's thread, so that no file is given between the loss of a scheduler and its notice."""
        if client.status != "running":
            return None
        return client.submit(work, job, pure=False, retries=self.choice.retries, resources=self.needs(task))

    def needs(self, task):
        if not self.choice.worker_memory:
            return None
        return {"memory": min(task["memory"], self.choice.worker_memory * 1e9)}

    def note(self, task, future):
        """Writes what a file has come to. False if that is lost with the scheduler."""
        from distributed.scheduler import KilledWorker

        if future.status == "error":
            error = future.exception()
            lost = isinstance(error, KilledWorker)
            self.plan.note({"output": task["output"], "status": "crashed" if lost else "failed",
                            "message": "the workers that had it were lost" if lost else str(error)})
            return True
        try:
            line, back, pictures = future.result()
        except (concurrent.futures.CancelledError, OSError):
            return False
        for path, content in back.items():
            put(os.path.join(self.plan.folder, path), content)
        for path, content in pictures.items():
            put(os.path.join(self.plan.root, path), content)
        self.plan.note(line)
        return True


def free_memory():
    return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 1e9


def connector(choice):
    """Makes clients: of the scheduler that is named, which may be away for a while, or of workers here."""
    from distributed import Client, LocalCluster

    if not choice.scheduler:
        choice.worker_memory = choice.worker_memory or free_memory() * 3 / 4
        cluster = LocalCluster(n_workers=1, threads_per_worker=choice.workers, processes=False, dashboard_address=":0",
                               resources={"memory": choice.worker_memory * 1e9})
        return lambda: Client(cluster)

    def connect():
        until = time.monotonic() + choice.patience
        while True:
            try:
                return Client(choice.scheduler, timeout=CONNECTING)
            except (OSError, asyncio.TimeoutError):
                if time.monotonic() > until:
                    sys.exit(f"autocuts.farm: no scheduler answers at {choice.scheduler}")

    return connect


def farm_options():
    options = argparse.ArgumentParser(prog="autocuts.farm", allow_abbrev=False, add_help=False,
                                      usage="python3 -m autocuts.farm COMMAND [options] IN... -o DIR")
    options.add_argument("--scheduler", help="address of the Dask scheduler; otherwise the work is done here")
    options.add_argument("--workers", type=int, default=os.cpu_count(), help="without a scheduler: files at once")
    options.add_argument("--worker-memory", type=float, metavar="GB",
                         help="memory that each worker has declared; without a scheduler: what may be used")
    options.add_argument("--send", action="store_true", help="send the files along: the workers share no folder with us")
    options.add_argument("--retries", type=int, default=2, help="for files that a worker could not begin")
    options.add_argument("--patience", type=float, default=600, metavar="SECONDS",
                         help="how long to wait for a scheduler that is away")
    return options


def main(arguments):
    options = farm_options()
    if not arguments or arguments[0] in ("-h", "--help"):
        options.print_help()
        print("\nAll other options are those of: autocuts-cli batch COMMAND")
        return 0
    choice, passed = options.parse_known_args(arguments)
    try:
        connect = connector(choice)
    except ImportError:
        sys.exit("autocuts.farm: Dask is missing. Install python3-distributed, or dask and distributed by pip")
    plan = Plan(passed, choice.send)
    named = [option for option in plan.head["arguments"] if os.path.exists(option.partition("=")[2])]
    if choice.send and named:
        plan.process.kill()
        sys.exit(f"autocuts.farm: the file of {named[0]} is not sent along. Use a shared folder without --send")
    try:
        Farm(plan, connect, choice).run()
    finally:
        code = plan.finish()
    return code


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
