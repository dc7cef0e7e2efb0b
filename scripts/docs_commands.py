#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every command that README.md and docs/*.md show, and compares the output that they show with what is printed.

docs_commands.py PROGRAM            exits 1 where a command fails or prints something else
docs_commands.py --update PROGRAM   writes what is printed into the pages

A fenced block `sh` is a script, which must succeed. In a fenced block `console` every line that begins with `$ ` is a command, and
what follows is its output, on lines of 100 characters or as `<!-- columns N -->` says; of a command that measures, numbers and verdicts may differ, and where it compares with a
committed bundle it may name the differences between the two builds, or say how many there are. A page is run in a copy of
the repository's folders, in which

- setup, build, test and check of scripts only check that they are there and can be executed,
- a run of a whole suite is planned (--dry-run), and a committed bundle is put where two of them would have written,
- programs that start jobs elsewhere (mpirun, parallel, sbatch), and a program with peers, do nothing,

and each of these is reported. So scripts/reproduce is run, except for the build and the run.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SLOW = ("setup", "build", "test", "check")
FINDS_ITS_ROOT = "reproduce"  # a script that goes to the folder above its own, so a link would leave the copy
ELSEWHERE = ("mpirun", "parallel", "sbatch")
STAND_INS = {"results/local/report": "baseline", "results/local/mine": "clang"}  # where a page lets a run write: committed bundle
MEASURING = re.compile(r"bezierbench (check|doctor|run)\b")
VARIES = re.compile(r"[-+~]?\d[\d.]*(e[-+]?\d+)?|\b(faster|slower|same|unresolved|ok)\b|-{3,}|\s+")
OTHER_BUILD = re.compile(r"^ +\w[^\n]* differs:\s.*?\sbefore,\s.*?\snow$|(^against +\S+); \d+ more with --all$", re.MULTILINE | re.DOTALL)
BLOCK = re.compile(r"^```(sh|console)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
COLUMNS = re.compile(r"<!-- columns (\d+) -->")
SKIPPED = "skipped: "

SLOW_STUB = """#!/usr/bin/env bash
real={root}/scripts/{name}
[[ -x $real ]] || {{ echo "no script {name}" >&2; exit 1; }}
if [[ {name} == check ]] && ! {root}/scripts/check 2>&1 | grep -q " $1 "; then echo "no check '$1'" >&2; exit 1; fi
echo "{skipped}scripts/{name} $*" >>"$DOCS_SKIPPED"
"""
ELSEWHERE_STUB = """#!/usr/bin/env bash
[[ -t 0 ]] || cat >/dev/null
echo "{skipped}{name} $*" >>"$DOCS_SKIPPED"
"""
PROGRAM_STUB = """#!/usr/bin/env bash
words=" $* "
if [[ $1 == run && $words != *' --dry-run '* && $words != *' --trials '* ]]; then
  {program} "$@" --dry-run >/dev/null || exit
  echo "{skipped}bezierbench $*, planned" >>"$DOCS_SKIPPED"
  [[ $words =~ ' --out '([^ ]+) ]] && out=${{BASH_REMATCH[1]}}
  declare -A stand_ins=({stand_ins})
  if [[ ${{stand_ins[$out]:-}} && ! -e $out ]]; then
    mkdir -p "$(dirname "$out")" && cp -rL "results/${{stand_ins[$out]}}" "$out"
  fi
  exit
fi
if [[ $words =~ ' --against '([^ ]+) && ! -e ${{BASH_REMATCH[1]}} ]]; then # a commit would be built
  echo "{skipped}bezierbench $*" >>"$DOCS_SKIPPED"
  exit
fi
exec {program} "$@"
"""


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def write_stub(path, text):
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


class Copy:
    """The repository's folders as one who has built the program sees them, with the stubs above."""

    def __init__(self, place, program):
        self.root = Path(place) / "bezierbench"
        stubs = Path(place) / "bin"
        for folder in (stubs, self.root / "build/release", self.root / "build/peers", self.root / "results/local", self.root / "scripts"):
            folder.mkdir(parents=True)
        for inner in ("", "results", "scripts"):
            for path in (ROOT / inner).iterdir():
                there = self.root / inner / path.name
                if not path.name.startswith(".") and path.name not in ("build", "local") and not there.exists():
                    there.symlink_to(path)
        for name in SLOW:
            (self.root / "scripts" / name).unlink(missing_ok=True)
            write_stub(self.root / "scripts" / name, SLOW_STUB.format(root=ROOT, name=name, skipped=SKIPPED))
        (self.root / "scripts" / FINDS_ITS_ROOT).unlink()
        shutil.copy(ROOT / "scripts" / FINDS_ITS_ROOT, self.root / "scripts")
        for name in ELSEWHERE:
            write_stub(stubs / name, ELSEWHERE_STUB.format(name=name, skipped=SKIPPED))
        stand_ins = " ".join(f"[{place}]={bundle}" for place, bundle in STAND_INS.items())
        write_stub(self.root / "build/release/bezierbench", PROGRAM_STUB.format(program=program, skipped=SKIPPED, stand_ins=stand_ins))
        write_stub(self.root / "build/peers/bezierbench", ELSEWHERE_STUB.format(name="build/peers/bezierbench", skipped=SKIPPED))
        self.skipped = Path(place) / "skipped"
        self.environment = {"PATH": f"{stubs}:{os.environ['PATH']}", "DOCS_SKIPPED": str(self.skipped), "NO_COLOR": "1",
                            "COLUMNS": "100", "LC_ALL": "C.UTF-8", "HOME": place, "TMPDIR": place,
                            **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}}  # of sanitizers

    def run(self, script):
        """(exit code, output, what was skipped)"""
        self.skipped.write_text("", encoding="utf-8")
        done = subprocess.run(["bash", "-c", script], cwd=self.root, env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout.replace(self.environment["HOME"], "~"), self.skipped.read_text(encoding="utf-8")


def transcript(text):
    """[(command, the output shown)] of a block `console`."""
    found = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found:
            found[-1][1].append(line)
    return [(command, "\n".join(lines).strip("\n")) for command, lines in found]


def masked(command, text):
    if MEASURING.search(command):
        return VARIES.sub(" ", OTHER_BUILD.sub(r"\1", text)).split()
    return [line.rstrip() for line in text.strip("\n").splitlines()]


def tidy(text):
    """Output as it stands in a page: no blanks at the ends of lines, no empty line at the end."""
    return "\n".join(line.rstrip() for line in text.splitlines()).strip("\n")


class Page:
    def __init__(self, path, program):
        self.path, self.program = path, program
        self.text = path.read_text(encoding="utf-8")
        self.faults = []

    def fault(self, at, what):
        self.faults.append(f"{self.path.relative_to(ROOT)}:{self.text.count(chr(10), 0, at) + 1}: {what}")

    def said(self, skipped):
        for line in skipped.splitlines():
            print(f"{self.path.relative_to(ROOT)}: {line}")

    def script(self, copy, match):
        code, output, skipped = copy.run("set -euo pipefail\n" + match[2])
        self.said(skipped)
        if code != 0:
            self.fault(match.start(), f"this script ends with {code}: {tidy(output)[-300:]}")
        return match[0]

    def console(self, copy, match):
        parts = []
        for command, shown in transcript(match[2]):
            code, output, skipped = copy.run(command)
            self.said(skipped)
            if code not in (0, 1):  # 1 is a finding, which may be what a page shows
                self.fault(match.start(), f"`{command}` ends with {code}: {tidy(output)[-300:]}")
            done = output.strip() or not skipped  # else it stands for what was not done
            if done and masked(command, shown) != masked(command, output):
                self.fault(match.start(), f"`{command}` prints something else; run scripts/docs_commands.py --update PROGRAM")
            printed = tidy(output) if done else shown
            parts.append(f"$ {command}\n" + (f"{printed}\n" if printed else ""))
        return "```console\n" + "".join(parts) + "```"

    def run(self):
        """The text with the output that was printed."""
        if not BLOCK.search(self.text):
            return self.text
        with tempfile.TemporaryDirectory(prefix="bezierbench-docs-") as place:
            copy = Copy(place, self.program)
            if width := COLUMNS.search(self.text):
                copy.environment["COLUMNS"] = width[1]
            return BLOCK.sub(lambda match: (self.script if match[1] == "sh" else self.console)(copy, match), self.text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--only", metavar="PAGE", help="the name of one page")
    parser.add_argument("program", type=lambda text: Path(text).resolve())
    options = parser.parse_args()
    faults = []
    for path in pages():
        if options.only and path.name != options.only:
            continue
        page = Page(path, options.program)
        text = page.run()
        if options.update and text != page.text:
            path.write_text(text, encoding="utf-8")
            print(f"{path.relative_to(ROOT)}: written")
        faults += [fault for fault in page.faults if not (options.update and "prints something else" in fault)]
    if faults:
        sys.exit("\n".join(faults))
    print("every command of README.md and docs was run")


if __name__ == "__main__":
    main()
