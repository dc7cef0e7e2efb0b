#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Other libraries' external methods: there when they are named, never otherwise. Usage: peers_test.py BEZIERBENCH"""
import json
import unittest

from program_case import ROOT, USAGE, Case, rows

SUITE = ROOT / "experiments/suites/peers.toml"
CURVE = "x,y\n0,0\n1,2\n3,-1\n4,0.5\n"


def is_peer(method):
    return method.startswith("peer_")


class Peers(Case):
    def setUp(self):
        super().setUp()
        self.peers = [r["id"] for r in rows(self.fine("list", "methods", "--format", "csv")) if is_peer(r["id"])
                      and r["problem"] == "evaluation"]

    def test_the_suite_is_listed_in_every_build(self):
        self.assertIn("peers", [r["id"] for r in rows(self.fine("list", "suites", "--format", "csv"))])
        self.assertIn("companion_peers", [r["id"] for r in rows(self.fine("list", "suites", "--format", "csv"))])
        self.assertIn("peers-speed", [r["id"] for r in rows(self.fine("list", "studies", "--format", "csv"))])

    def test_a_build_without_a_library_says_how_to_have_it(self):
        shipped = [m for m in ("peer_2geom", "peer_gsl", "peer_sisl") if m not in self.peers]
        curve = self.write("c.csv", CURVE)
        for method in shipped:
            remedy = (method, "not in this build", "-DBEZIERBENCH_PEERS=ON", "scripts/setup --peers")
            suite = self.suite(methods=f'["direct", "{method}"]')
            self.refused(USAGE, ["run", suite, "--out", "b"], "s.toml:", *remedy)
            self.refused(USAGE, ["curve", "eval", "--curve", curve, "--t", "0.5", "--method", method], *remedy)
        if not self.peers:
            self.refused(USAGE, ["run", SUITE, "--out", "b"], "peers.toml:", "not in this build", "-DBEZIERBENCH_PEERS=ON")

    def test_nothing_but_a_name_calls_a_peer(self):
        self.fine("run", self.suite(methods=None, degree="[2]"), "--out", "all", "--quiet")
        self.fine("run", self.suite(methods='["*"]', degree="[2]"), "--out", "star", "--quiet")
        for bundle in ("all", "star"):
            found = self.table(f"{bundle}/accuracy.csv") + self.table(f"{bundle}/unstable.csv")
            self.assertGreater(len(found), 20)
            self.assertEqual([r["method"] for r in found if is_peer(r["method"])], [])
        curve = self.write("c.csv", CURVE)
        evaluated = rows(self.fine("curve", "eval", "--curve", curve, "--t", "0.5"))
        self.assertEqual([r["method"] for r in evaluated if is_peer(r["method"])], [])

    def test_the_suite_judges_and_times_them_like_our_own(self):
        if not self.peers:
            self.skipTest("this build has no peers")
        lines = SUITE.read_text()
        for absent in {m for m in lines.replace('"', " ").replace(",", " ").split() if is_peer(m)} - set(self.peers):
            lines = lines.replace(f', "{absent}"', "")  # its library is not here
        self.write("peers.toml", lines)
        self.fine("run", "peers.toml", "--out", "b", "--trials", "50", "--set", "degree=3,20", "--quiet")
        errors = self.table("b/unstable.csv")
        self.assertEqual({r["method"] for r in errors}, set(self.peers))
        self.assertEqual({r["status"] for r in errors}, {"ok"})
        self.assertEqual([r["method"] for r in self.table("b/accuracy.csv") if is_peer(r["method"])], [])
        self.assertEqual([r["method"] for r in self.table("b/worst.csv") if is_peer(r["method"])], [])
        timed = [r for r in self.table("b/timing.csv") if is_peer(r["method"])]
        self.assertEqual({(r["method"], r["mode"]) for r in timed}, {(m, mode) for m in self.peers for mode in ("one_shot", "point")})
        self.assertEqual({r["checked"] for r in timed}, {"yes"})
        self.assertTrue(json.loads((self.folder / "b/machine.json").read_text())["peers"])
        self.fine("verify", "b")

    def test_lengths_and_foot_points_of_libraries_like_our_own(self):
        listed = {r["id"] for r in rows(self.fine("list", "methods", "--format", "csv"))}
        if not {"peer_2geom_length", "peer_occt_length", "peer_sisl_closest"} <= listed:
            self.skipTest("this build is without 2geom, Open CASCADE or SISL")
        self.fine("run", SUITE.parent / "companion_peers.toml", "--out", "b", "--trials", "20", "--no-timing", "--quiet")
        lengths = {r["method"]: r for r in self.table("b/arc_length.csv") + self.table("b/arc_length_unstable.csv")}
        self.assertEqual(set(lengths), {"gauss_legendre_adaptive", "peer_2geom_length", "peer_occt_length"})
        self.assertEqual({r["method"] for r in self.table("b/arc_length.csv")}, {"gauss_legendre_adaptive"})
        self.assertEqual({r["method"] for r in self.table("b/projection_unstable.csv")},
                         {"peer_2geom_nearest", "peer_sisl_closest"})
        self.write("q.csv", "x,y\n0,0\n0.5,0\n1,1\n")  # (t, t^2)
        found = rows(self.fine("curve", "project", "--curve", "q.csv", "--point", "0,1.25", "--method", "peer_2geom_nearest"))
        self.assertLess(float(found[0]["error"]), 1e-9)
        found = rows(self.fine("curve", "length", "--curve", "q.csv", "--method", "peer_2geom_length"))
        self.assertLess(float(found[0]["error"]), 1e-6)

    def test_a_degree_that_a_library_refuses_is_said(self):
        if "peer_occt_bsplclib" not in self.peers:
            self.skipTest("this build has no Open CASCADE")
        self.fine("run", self.suite(methods='["peer_occt_bsplclib"]', degree="[25, 26]"), "--out", "b", "--quiet")
        self.assertEqual([(r["degree"], r["status"]) for r in self.table("b/unstable.csv")],
                         [("25", "ok"), ("26", "degree_unsupported")])

    def test_peers_exist_in_double_only(self):
        if not self.peers:
            self.skipTest("this build has no peers")
        suite = self.suite(methods=f'["{self.peers[0]}"]', scalar='["float"]')
        self.refused(USAGE, ["run", suite, "--out", "b"], self.peers[0], "float", "list methods")


if __name__ == "__main__":
    unittest.main()
