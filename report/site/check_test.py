# SPDX-License-Identifier: MIT
"""check.py finds a fault of each kind and accepts a correct page."""
import tempfile
import unittest
from pathlib import Path

from . import check

PAGE = "<html><head><title>t</title></head><body><main><h1 id='top'>h</h1>{}</main></body></html>"
FAULTY = {
    "<p>": "mismatched tag",
    "<p id='top'>twice</p>": "2 elements have the id top",
    "<h1>another</h1>": "2 elements h1",
    "<img src='a.svg' />": "without a text",
    "<img src='https://example.org/a.svg' alt='' />": "from elsewhere",
    "<img src='//example.org/a.svg' alt='' />": "from elsewhere",
    "<style>p { background: url(http://example.org/a.png) }</style>": "from elsewhere",
    "<a href='other.html'>x</a>": "leads nowhere",
    "<a href='../page.html'>x</a>": "leads nowhere",
    "<a href='/page.html'>x</a>": "is not relative",
    "<a href='page.html#bottom'>x</a>": "has no anchor bottom",
    "<a href='#bottom'>x</a>": "has no anchor bottom",
}
RIGHT = "<p><a href='#top'>x</a> <a href='page.html#top'>y</a> <a href='https://example.org/'>z</a> <img src='a.svg' alt='a' /></p>"


class Check(unittest.TestCase):
    def faults(self, inner):
        with tempfile.TemporaryDirectory() as place:
            Path(place, "page.html").write_text(PAGE.format(inner), encoding="utf-8")
            Path(place, "a.svg").write_text("<svg/>", encoding="utf-8")
            return list(check.faults(place))

    def test_a_correct_page(self):
        self.assertEqual(self.faults(RIGHT), [])

    def test_each_fault(self):
        for inner, words in FAULTY.items():
            with self.subTest(inner):
                found = self.faults(inner)
                self.assertEqual(len(found), 1, found)
                self.assertIn(words, found[0])


if __name__ == "__main__":
    unittest.main()
