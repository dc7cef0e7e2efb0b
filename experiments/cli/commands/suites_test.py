#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What `run` refuses of a suite, with the line and the column. Usage: suites_test.py BEZIERBENCH"""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from program_case import CONVERSION, STUDY, TIMING, USAGE, Case, lines_of  # noqa: E402


class Suites(Case):
    def at(self, key, lines, needle, key_line=None):
        """`lines` are refused with the line of `key`, and a column."""
        self.write("s.toml", "\n".join(lines) + "\n")
        number = key_line or 1 + next(k for k, line in enumerate(lines) if line.startswith(key))
        result = self.refused(USAGE, ["run", "s.toml", "--out", "b"], needle)
        self.assertRegex(result.stderr.decode(), rf"\Abezierbench: s\.toml:{number}:[1-9][0-9]*: ")

    def test_values(self):
        for key, value, needle in [
                ("kind", '"acuracy"', 'did you mean "accuracy"?'), ("kind", "3", "kind"), ("kind", '""', "kind"),
                ("curve", '"bernstien"', 'did you mean "bernstein"?'), ("curve", "[1]", "curve"),
                ("methods", '["de_castlejau"]', 'did you mean "de_casteljau"?'), ("methods", '["zz*"]', '"zz*"'),
                ("methods", '["direct", "direct"]', "twice"), ("methods", '"direct"', "methods"),
                ("methods", "[1]", "methods"), ("generator", '["continous"]', 'did you mean "continuous"?'),
                ("generator", "[]", "a value in it"), ("generator", '"report"', "generator"),
                ("baseline", '["exakt"]', 'did you mean "exact"?'), ("baseline", "[]", "a value in it"),
                ("published", '"report_table.csv"', 'did you mean "report_tables.csv"?'), ("published", "1", "published"),
                ("degree", "3", "degree"), ("degree", '["x"]', "whole number"), ("degree", "[1.5]", "whole number"),
                ("degree", "[]", "degree"), ("degree", "[-1]", "0 to"), ("degree", "[1024]", "0 to"),
                ("degree", "[99999999999]", "0 to"), ("degree", "[3, 3]", "twice"), ("degree", "[nan]", "whole number"),
                ("coordinate_range", "[nan]", "finite"), ("coordinate_range", "[inf]", "finite"),
                ("coordinate_range", '["nan"]', "finite"), ("coordinate_range", "[-1]", "negative"),
                ("coordinate_range", "[]", "a value in it"), ("coordinate_range", "[true]", "number"),
                ("coordinate_range", '["1e999"]', "number"), ("coordinate_range", '["1e-999"]', "number"), ("t_interval", "[[0, nan]]", "finite"),
                ("t_interval", "[[-inf, 1]]", "finite"), ("t_interval", "[[1, 0]]", "a <= b"),
                ("t_interval", "[0, 1]", "intervals"), ("t_interval", "[[0]]", "intervals"), ("t_interval", "[]", "a value in it"),
                ("dimension", "[4]", "1, 2 or 3"), ("dimension", "[]", "a value in it"), ("scalar", '["half"]', "scalar"),
                ("scalar", "[]", "a value in it"), ("trials", "0", "at least 1"), ("trials", "[5]", "whole number"),
                ("trials", "nan", "whole number"), ("replicates", "0", "at least 1"), ("modes", '["point"]', "timing"),
                ("id", '"a b"', "id"), ("id", '"."', "begin with"), ("id", '".."', "begin with"), ("id", '"-x"', "begin with"), ("id", '""', "id"), ("id", "7", "string"), ("title", "7", "string"),
                ("id", f'"{"n" * 101}"', "101 characters")]:
            with self.subTest(key=key, value=value):
                self.at(f"{key} =" if key not in ("id", "title") else key, lines_of(**{key: value}), needle,
                        key_line=7 if key == "id" else 14 if key == "title" else None)

    def test_values_that_do_not_fit_together(self):
        self.at("coordinate_range", lines_of(generator='["integer"]', coordinate_range="[10, 0.5]"), "0.5")
        self.at("coordinate_range", lines_of(scalar='["float"]', coordinate_range="[1e39]"), "float")
        self.at("generator", lines_of(generator='["weights_mild"]'), "only rational curves have")
        self.at("generator", lines_of(curve='"rational"', generator='["continuous"]'), "weights_mild, weights_wild")
        self.at("degree", lines_of(generator='["multiple_root"]', degree="[34]"), "up to degree 33")

    def test_structure(self):
        for lines, line, needle in [
                (lines_of(kind='"acuracy"'), 8, 'did you mean "accuracy"?'), (lines_of(degre="[3]"), 14, 'did you mean "degree"?'),
                ([line.replace("tiny", "n" * 101) for line in lines_of()], 3, "101 characters"), (lines_of(kind=None), 6, "kind is missing"), (lines_of() + ["dimension = ["], 14, "not TOML")]:
            with self.subTest(needle=needle):
                self.write("s.toml", "\n".join(lines) + "\n")
                self.refused(USAGE, ["run", "s.toml", "--out", "b"], f"bezierbench: s.toml:{line}:", needle)

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
                (STUDY, {"id": '"d"', "kind": '"derivative"', "order": "[1]", "curve": '"rational"'}, "curve", "derivatives"),
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
