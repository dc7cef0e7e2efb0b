# SPDX-License-Identifier: MIT
"""What the tests of runs that are stopped, shared out or disturbed have in common."""
import hashlib
import os
import re
import shutil
import signal
import subprocess
import time

from program_case import FINE, INTERRUPTED, PATIENCE, PROGRAM, STUDY, Case

NOISY = ("machine.json", "SHA256SUMS")  # the load of the machine is in the former
# Several blocks per replicate, several replicates per cell, cells in two scalar types, and every kind of study.
ACCURACY = {**STUDY, "degree": "[3, 9]", "trials": "2200", "replicates": "2", "decomposed_trials": "20",
            "scalar": '["double", "float"]', "baseline": '["exact", "direct"]',
            "methods": '["direct", "de_casteljau", "direct_pow"]'}
SEARCH = {"id": '"s"', "kind": '"search"', "curve": '"bernstein"', "degree": "[3, 5]", "coordinate_range": "[1]",
          "trials": "300", "budget": "300", "methods": '["direct", "de_casteljau"]'}


class ResumeCase(Case):
    def results(self, bundle):
        """Everything that does not depend on the time: name and bytes."""
        return {path.name: path.read_bytes() for path in (self.folder / bundle).iterdir()
                if path.suffix in (".csv", ".json", ".toml") and path.name not in NOISY and "timing" not in path.name}

    def block_files(self, bundle):
        try:
            names = os.listdir(self.folder / bundle / "blocks")
        except FileNotFoundError:  # not yet, or no more
            return []
        return [self.folder / bundle / "blocks" / name for name in sorted(names) if name.endswith(".blocks")]

    def change(self, bundle, name, content):
        """Another content of a file, with its checksum."""
        path, sums = self.folder / bundle / name, self.folder / bundle / "SHA256SUMS"
        self.assertNotEqual(path.read_text(), content)
        path.write_text(content)
        line = f"{hashlib.sha256(content.encode()).hexdigest()}  {name}"
        sums.write_text(re.sub(rf"^\w+  {re.escape(name)}$", line, sums.read_text(), flags=re.MULTILINE))

    def pretend_another_machine(self, bundle):
        text = (self.folder / bundle / "machine.json").read_text()
        self.change(bundle, "machine.json", re.sub(r'"model_name": "[^"]*"', '"model_name": "Other"', text))

    def stop(self, seconds, which, *arguments):
        """Sends a signal after so many seconds; the result."""
        with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            try:
                out, err = process.communicate(timeout=seconds)
            except subprocess.TimeoutExpired:
                process.send_signal(which)
                out, err = process.communicate(timeout=PATIENCE)
        return subprocess.CompletedProcess(arguments, process.returncode, out, err)

    def start_and_stop(self, name, *arguments, which=signal.SIGKILL):
        """A run that was stopped when some of its blocks were done, but not all."""
        for _ in range(20):
            code = self.stop_when(lambda: self.block_files(name), which, "run", *arguments, "--quiet", "--checkpoint", 0,
                                  "--out", name)
            if code != FINE:
                break
            shutil.rmtree(self.folder / name)  # it was faster
        self.assertEqual(code, -which if which == signal.SIGKILL else INTERRUPTED)
        self.assertTrue(self.block_files(name))
        self.assert_not_complete(name)

    def stop_when(self, true, which, *arguments):
        with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stderr=subprocess.PIPE) as process:
            deadline = time.monotonic() + PATIENCE
            while not true() and process.poll() is None and time.monotonic() < deadline:
                time.sleep(0.002)
            process.send_signal(which)
            process.communicate(timeout=PATIENCE)
        return process.returncode
