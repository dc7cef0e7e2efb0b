#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What `run` refuses of a suite, with the line and the column. Usage: suites_test.py BEZIERBENCH"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import CONVERSION, STUDY, TIMING, USAGE, Case, lines_of  # noqa: E402


class Suites(Case):
    def test_values(self):
        """Each with its place; tests of the reader have all of them."""
        for changes, line, needle in [
                ({"kind": '"acuracy"'}, 8, 'did you mean "accuracy"?'), ({"degree": "[3, 1024]"}, 10, "0 to"),
                ({"methods": '["de_castlejau"]'}, 13, 'did you mean "de_casteljau"?'),
                ({"id": f'"{"n" * 101}"'}, 7, "101 characters"),
                ({"generator": '["integer"]', "coordinate_range": "[10, 0.5]"}, 11, "0.5"),
                ({"modes": '["point"]'}, 14, "timing"),
                ({"kind": None}, 6, "kind is missing")]:
            with self.subTest(changes=changes):
                self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"], f"bezierbench: s.toml:{line}:",
                             needle)

    def test_bytes_that_are_no_text(self):
        for content in (b"schema_version = 1\0\n", b"\xff\xfe\n"):
            with self.subTest(content=content[:30]):
                self.write("s.toml", content)
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], "s.toml:1:")

    def test_line_ends_and_byte_order_mark(self):
        self.write("s.toml", "\ufeff" + "\r\n".join(lines_of(id=f'"{"n" * 100}"')) + "\r\n")
        self.bundle("s.toml")

    def test_ids_are_unique_over_files(self):
        self.suite()
        other = "\n".join(lines_of()).replace("tiny", "other")
        self.write("other.toml", other)
        self.write("fine.toml", other.replace('"a"', '"b"'))
        self.refused(USAGE, ["run", "s.toml", "other.toml", "--out", "b"], "other.toml", 'study "a"', '"tiny"', '"other"')
        self.refused(USAGE, ["run", "s.toml", "s.toml", "--out", "b"], "s.toml", 'the id "tiny"')
        self.bundle("s.toml", "fine.toml")
        self.bundle("b/suite.toml", name="again")  # the resolved suites are a suite file
        self.assertEqual(self.manifest("b"), self.manifest("again"))

    def test_what_the_plan_refuses(self):
        """At once, not after hours, with the place of the key; of the study where the key is left out."""
        for study, changes, key, needle in [
                (CONVERSION, {"curve": '"rational"', "methods": None}, "curve", "power"),
                (TIMING, {"methods": '["gauss_legendre_24"]', "modes": '["one_shot"]'}, None, "tolerance"),
                (TIMING, {"methods": '["direct"]', "baseline": '"de_casteljau"'}, "baseline", "de_casteljau"),
                (TIMING, {"kind": '"arc_length"', "tolerance": "[1e-6]", "t_interval": "[[0, 2]]"}, "t_interval", "within")]:
            asked = {**study, **changes}
            lines = lines_of({**STUDY, "degree": "[2]"}, asked)
            header = len(lines) - lines[::-1].index("[[study]]")
            found = [number for number, line in enumerate(lines, 1) if number > header and key and line.startswith(f"{key} =")]
            place = f"s.toml:{found[0]}:" if found else f"s.toml:{header}:1: "
            with self.subTest(asked=asked):
                self.write("s.toml", "\n".join(lines) + "\n")
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], f"bezierbench: {place}", needle)

    def test_file_that_cannot_be_read(self):
        for name in ("absent.toml", "./", "absent/s.toml"):
            with self.subTest(name=name):
                self.refused(USAGE, ["run", name, "--out", "b"], f"bezierbench: {name}: cannot be read")

    def test_methods_that_take_another_form(self):
        for changes in ({"methods": '["horner"]'}, {"baseline": '["power_sum"]'}, {"curve": '"power"'}):
            with self.subTest(changes=changes):
                self.refused(USAGE, ["run", self.suite(**changes), "--out", "b"], 'study "a"', "form")
        self.refused(USAGE, ["run", self.suite(CONVERSION, methods='["exact+exat"]'), "--out", "b"], '"exact"')


if __name__ == "__main__":
    unittest.main()
