#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The completions of the shells, in the shells. Usage: completion_test.py BEZIERBENCH"""
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import PROGRAM, Case, rows  # noqa: E402

SCRIPTS = Path(__file__).resolve().parent / "completions"
BASH = """source "$1"
COMP_LINE=$2 COMP_POINT=${#2}
_bezierbench
printf '%s\\n' "${COMPREPLY[@]}"
"""


class Shells(Case):
    def setUp(self):
        super().setUp()
        self.path = {**os.environ, "PATH": f"{Path(PROGRAM).parent}:{os.environ['PATH']}", "HOME": str(self.folder),
                     "LC_ALL": "C.UTF-8"}
        (self.folder / "bundle").mkdir()
        self.write("curve.csv", "x\n1\n")

    def output(self, *command):
        result = subprocess.run(command, cwd=self.folder, env=self.path, check=True, timeout=60, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(result.stderr, b"", command)
        return result.stdout.decode().split()

    def bash(self, line):
        """What bash puts in place of what follows the last blank, = or colon."""
        return self.output("bash", "-c", BASH, "bash", str(SCRIPTS / "bezierbench.bash"), line)

    def ids(self, topic, **wanted):
        table = rows(self.fine("list", topic, "--format", "csv"))
        return [row["id"] for row in table if wanted.items() <= row.items()]

    def test_bash(self):
        self.assertIn("run", self.bash("bezierbench "))
        self.assertNotIn("complete", self.bash("bezierbench "))  # it is for the shells only
        self.assertEqual(self.bash("bezierbench cu"), ["curve", "curves"])
        self.assertEqual(self.bash("bezierbench --help"), ["--help"])
        self.assertEqual(self.bash("bezierbench run --tri"), ["--trials"])
        for files in ("run report --out b", "compare bundle b", "curve eval --curve c", "judge c", "run report --set x"):
            self.assertEqual(self.bash(f"bezierbench {files}"), [])  # for which bash offers files
        self.assertEqual(self.bash("bezierbench check horner_b"), self.bash("bezierbench curve eval --method horner_b"))
        self.assertEqual(self.bash("bezierbench list methods --format "), ["text", "csv"])
        self.assertEqual(self.bash("bezierbench list methods --format=c"), ["csv"])
        self.assertEqual(self.bash(f"{PROGRAM} verif"), ["verify"])

    def test_bash_knows_all_ids(self):
        self.assertLessEqual(set(self.ids("suites")), set(self.bash("bezierbench run ")))
        evaluators = self.ids("methods", problem="evaluation")
        self.assertEqual(set(self.bash("bezierbench curve eval --method ")), set(evaluators))
        self.assertEqual(set(self.bash("bezierbench curve length --method ")), set(self.ids("methods", problem="arc_length")))
        self.assertEqual(self.bash("bezierbench run x --set generator="), self.ids("generators"))

    def test_bash_breaks_words_at_colons_and_equals_signs(self):
        self.assertEqual(self.bash("bezierbench curve eval --method exact_dd:"), ["horner_dd"])
        self.assertEqual(self.bash("bezierbench curve eval --method=exact_dd:"), ["horner_dd"])
        self.assertEqual(self.bash("bezierbench run x --set degr"), ["degree="])
        self.assertEqual(self.bash("bezierbench run x --set generator=dy"), ["dyadic"])

    @unittest.skipUnless(shutil.which("fish"), "fish is not installed")
    def test_fish(self):
        def fish(line):
            script = 'source $argv[1]; complete --do-complete $argv[2]'
            result = subprocess.run(["fish", "--no-config", "-c", script, SCRIPTS / "bezierbench.fish", line],
                                    cwd=self.folder, env=self.path, check=True, timeout=60, stdout=subprocess.PIPE)
            return [line.split("\t")[0] for line in result.stdout.decode().splitlines()]

        self.assertEqual(fish("bezierbench cu"), ["curve", "curves"])
        self.assertEqual(fish("bezierbench run --tri"), ["--trials"])
        self.assertLessEqual(set(self.ids("suites")), set(fish("bezierbench run ")))
        self.assertEqual(fish("bezierbench curve eval --method exact_dd:"), ["exact_dd:horner_dd"])
        self.assertEqual(fish("bezierbench run x --set generator=dy"), ["generator=dyadic"])
        self.assertEqual(fish("bezierbench verify b"), ["bundle/"])
        self.assertEqual(fish("bezierbench curve eval --curve c"), ["curve.csv"])

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh(self):
        """On a terminal, since zsh completes nowhere else. Control-X shows the line that it has made."""
        parent, child = pty.openpty()
        with subprocess.Popen(["zsh", "-f", "-i"], cwd=self.folder, env={**self.path, "TERM": "dumb"}, stdin=child,
                              stdout=child, stderr=child, start_new_session=True) as shell:
            os.close(child)
            try:
                self.check_zsh(parent)
            finally:
                shell.kill()
                os.close(parent)

    def check_zsh(self, terminal):
        def until(pattern):
            written, end = "", time.monotonic() + 60
            while not (found := re.search(pattern, written)):
                self.assertTrue(select.select([terminal], [], [], end - time.monotonic())[0], written)
                written += os.read(terminal, 65536).decode()
            return found

        def zsh(line):
            os.write(terminal, f"{line}\t\x18".encode())
            return until("<([^>]*)>")[1]

        for line in (f"fpath=({SCRIPTS} $fpath)", "autoload -Uz compinit", "compinit -u -D", "show() { print -r -- \"<$BUFFER>\"; BUFFER= }; zle -N show; bindkey '^X' show",
                     "setopt no_auto_list no_auto_menu; print -r -- re''ady"):
            os.write(terminal, f"{line}\n".encode())
        until("\nready")
        self.assertEqual(zsh("bezierbench doc"), "bezierbench doctor ")
        self.assertEqual(zsh("bezierbench run --tri"), "bezierbench run --trials ")
        self.assertEqual(zsh("bezierbench run lad"), "bezierbench run ladder ")
        self.assertEqual(zsh("bezierbench curve eval --method exact_dd:"), "bezierbench curve eval --method exact_dd:horner_dd ")
        self.assertEqual(zsh("bezierbench run x --set degr"), "bezierbench run x --set degree=")
        self.assertEqual(zsh("bezierbench run x --set generator=dy"), "bezierbench run x --set generator=dyadic ")
        self.assertEqual(zsh("bezierbench verify bu"), "bezierbench verify bundle/")
        self.assertEqual(zsh("bezierbench run x --out=bu"), "bezierbench run x --out=bundle/")


if __name__ == "__main__":
    unittest.main()
