"""Builds the documentation site: docs/, the README and the class reference as HTML pages that open from disk."""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

from docs_site.class_page import as_markdown, read_classes
from docs_site.readme import update

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).parent
# Pages outside of docs/, and their names in the site.
OUTSIDE = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}
# Links as they are in the repository, and in the site.
LINKS = {
    "](docs/": "](",
    "](../models/": "](models/",
    "](LICENSE)": "](LICENSE.txt)",
    **{f"]({prefix}{name}": f"]({page}" for name, page in OUTSIDE.items() for prefix in ("../", "")},
}
ASSETS = ["iframe-worker.js", "wide.css"]
QUIET = {"NO_MKDOCS_2_WARNING": "1"}  # an advertisement of 20 lines


def main() -> int:
    parser = argparse.ArgumentParser(prog="docs", description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "build/docs", help="folder of the site")
    parser.add_argument("--demo", type=Path, help="first renew the README's table and picture from this demo")
    given = parser.parse_args()
    if given.demo:
        update(given.demo)
    work = ROOT / "build/docs_work"
    shutil.rmtree(work, ignore_errors=True)
    gather(work / "docs_pages")
    (work / "mkdocs.yml").write_text((HERE / "mkdocs.yml").read_text() + nav_of_classes())
    out = given.out.resolve()
    command = ["mkdocs", "build", "--strict", "--config-file", work / "mkdocs.yml", "--site-dir", out]
    # With --quiet, --strict would see no warnings.
    made = subprocess.run(
        [sys.executable, "-m", *command], env={**os.environ, **QUIET}, stderr=subprocess.PIPE, text=True
    )
    if made.returncode == 0:
        print(f"open {out / 'index.html'}")
    else:
        print(made.stderr, file=sys.stderr)
    return made.returncode


def gather(pages: Path) -> None:
    """All pages and pictures of the site, with links as they are there."""
    shutil.copytree(ROOT / "docs", pages)
    shutil.copytree(ROOT / "models", pages / "models", ignore=shutil.ignore_patterns("*.gesture"))
    shutil.copyfile(ROOT / "LICENSE", pages / "LICENSE.txt")
    (pages / "assets").mkdir()
    for name in ASSETS:
        shutil.copyfile(HERE / name, pages / "assets" / name)
    for name, page in OUTSIDE.items():
        shutil.copyfile(ROOT / name, pages / page)
    for page in pages.glob("*.md"):
        text = page.read_text()
        for there, here in LINKS.items():
            text = text.replace(there, here)
        page.write_text(text)
    classes = read_classes()
    (pages / "classes").mkdir()
    for name in classes:
        (pages / "classes" / f"{name}.md").write_text(as_markdown(name, classes))


def nav_of_classes() -> str:
    lines = [f"      - {name}: classes/{name}.md" for name in sorted(read_classes())]
    return "\n".join(["  - Class reference:", *lines, ""])


if __name__ == "__main__":
    sys.exit(main())
