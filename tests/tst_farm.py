"""autocuts.farm: the same files as autocuts-cli batch makes, whatever happens to workers and schedulers."""

import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

CLI = os.environ["AUTOCUTS_CLI"]
OPTIONS = ["unwrap", "--quality", "draft", "--pack-time", "0"]
FILES = 16


def sheet(n):
    """An OBJ file with n times n squares, which are bent."""
    points = "".join(f"v {x} {y} {x * x / n}\n" for y in range(n + 1) for x in range(n + 1))
    corners = [(y * (n + 1) + x + 1, n + 1) for y in range(n) for x in range(n)]
    return "mtllib m.mtl\n" + points + "".join(f"f {c} {c + 1} {c + row + 1} {c + row}\n" for c, row in corners)


def free_address():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return f"tcp://127.0.0.1:{probe.getsockname()[1]}"


def outputs(folder):
    found = {}
    for place, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(place, name)
            if name.endswith(".obj"):
                with open(path, "rb") as file:
                    found[os.path.relpath(path, folder)] = file.read()
    return found


class Farming(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        os.makedirs(cls.at("in/deep"))
        for i in range(FILES):
            with open(cls.at(f"in/{'deep/' if i % 3 == 0 else ''}{i}.obj"), "w", encoding="utf-8") as file:
                file.write(sheet(3 + i % 4))
        with open(cls.at("in/broken.obj"), "w", encoding="utf-8") as file:
            file.write("v 0 0\n")
        ran = subprocess.run([CLI, "batch", *OPTIONS, "in", "-o", "plain", "--report", "plain.json"], cwd=cls.at(""),
                             capture_output=True, check=False)
        assert ran.returncode == 1, ran.stderr
        cls.expected = outputs(cls.at("plain"))
        assert len(cls.expected) == FILES

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    @classmethod
    def at(cls, name):
        return os.path.join(cls.place.name, name)

    def start(self, *command):
        process = subprocess.Popen(command, cwd=self.at(""), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   start_new_session=True)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.returncode is None:
            os.killpg(process.pid, signal.SIGKILL)
        process.communicate()

    def start_dask(self, program, *arguments):
        """A scheduler or worker, which goes on to work when its messages are read no more."""
        process = subprocess.Popen([sys.executable, "-m", f"distributed.cli.{program}", *arguments], start_new_session=True,
                                   cwd=self.at(""), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(self.end, process)
        return process

    def start_scheduler(self, address):
        return self.start_dask("dask_scheduler", "--host", address, "--no-dashboard", "--dashboard-address", ":0")

    def start_worker(self, address):
        return self.start_dask("dask_worker", address, "--no-nanny", "--nthreads", "1", "--no-dashboard", "--local-directory",
                               self.at("dask"))

    def start_farm(self, folder, *options):
        return self.start(sys.executable, "-X", "faulthandler", "-m", "autocuts.farm", *OPTIONS, "in", "-o", folder, "--progress", "json", *options)

    def compare(self, process, folder):
        try:
            out, err = process.communicate(timeout=200)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGABRT)  # it says where it hangs
            out, err = process.communicate()
        self.assertEqual((process.returncode, out), (1, f"done: {FILES}\nfailed: 1\n"), err)
        self.assertEqual(outputs(self.at(folder)), self.expected)
        with open(self.at(f"{folder}/autocuts-batch.jsonl"), encoding="utf-8") as file:
            done = sorted(json.loads(line)["output"] for line in file.read().splitlines()[1:])
        self.assertEqual(done, sorted([*self.expected, "broken.obj"]))

    def test_reports_are_those_of_the_batch(self):
        for way in ([], ["--send"]):
            folder = "farmed" + "".join(way)
            self.compare(self.start_farm(folder, "--report", f"{folder}.json", *way), folder)
            reports = []
            for name in ("plain.json", f"{folder}.json"):
                with open(self.at(name), encoding="utf-8") as file:
                    reports.append(json.load(file))
                for result in reports[-1]["files"]:
                    del result["seconds"]
            self.assertEqual(*reports)

    def test_pages_have_pictures(self):
        for way in ([], ["--send"]):
            folder = "drawn" + "".join(way)
            self.compare(self.start_farm(folder, "--report", f"{folder}.html", *way), folder)
            with open(self.at(f"{folder}.html"), encoding="utf-8") as file:
                self.assertEqual(file.read().count("data:image/png;base64,"), FILES)

    def test_a_worker_is_killed(self):
        address = free_address()
        self.start_scheduler(address)
        workers = [self.start_worker(address) for _ in range(2)]
        farm = self.start_farm("killed", "--scheduler", address)
        for _ in range(4):
            self.assertIn("status", json.loads(farm.stderr.readline()))
        os.killpg(workers[0].pid, signal.SIGKILL)
        self.compare(farm, "killed")

    def test_the_scheduler_is_restarted(self):
        address = free_address()
        scheduler = self.start_scheduler(address)
        self.start_worker(address)
        farm = self.start_farm("restarted", "--scheduler", address)
        for _ in range(4):
            self.assertIn("status", json.loads(farm.stderr.readline()))
        os.killpg(scheduler.pid, signal.SIGKILL)
        scheduler.wait()
        self.start_scheduler(address)
        self.start_worker(address)
        self.compare(farm, "restarted")

    def test_a_killed_farm_goes_on(self):
        farm = self.start_farm("resumed", "--workers", "2")
        for _ in range(4):
            self.assertIn("status", json.loads(farm.stderr.readline()))
        os.killpg(farm.pid, signal.SIGKILL)
        farm.wait()
        again = self.start_farm("resumed", "--workers", "2", "--resume")
        self.assertGreaterEqual(json.loads(again.stderr.readline())["total"], 1)
        self.assertLess(json.loads(again.stderr.readline())["total"], FILES - 2)
        self.compare(again, "resumed")

    def test_mistakes_are_said(self):
        for options, code, text in ((["unwrap", "--qualty", "draft"], 2, "did you mean --quality"),
                                    (["transfer", "--send", "--from", "plain/1.obj"], 1, "plain/1.obj is not sent along")):
            with self.subTest(options):
                farm = self.start(sys.executable, "-m", "autocuts.farm", *options, "in", "-o", "wrong")
                out, err = farm.communicate()
                self.assertEqual((farm.returncode, out), (code, ""), err)
                self.assertIn(text, err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
