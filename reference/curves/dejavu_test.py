# SPDX-License-Identifier: MIT
"""The sets of curves beside this file are what dejavu.py makes of the fonts. Exit 77 where fontTools or a font is missing."""
import importlib.util
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def main():
    if importlib.util.find_spec("fontTools") is None:
        print("skipped: python3-fonttools is not installed")
        return 77
    spec = importlib.util.spec_from_file_location("dejavu", HERE / "dejavu.py")
    dejavu = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(dejavu)
    fonts = [*dejavu.OUTLINED, *(f"DejaVu{family}" for family in dejavu.FAMILIES)]
    missing = sorted({name for name in fonts if not (dejavu.FOLDER / f"{name}.ttf").is_file()})
    if missing:
        print(f"skipped: {', '.join(missing)} not in {dejavu.FOLDER}; install fonts-dejavu-core and fonts-dejavu-extra")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        sys.argv = ["dejavu.py", folder]
        dejavu.main()
        different = [made.name for made in Path(folder).iterdir() if made.read_bytes() != (HERE / made.name).read_bytes()]
    for name in different:
        print(f"{HERE / name}: not what dejavu.py makes of the fonts; run it, or install fonts-dejavu 2.37-6")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
