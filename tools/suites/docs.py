"""The documentation: links, commands, scripts, lengths, sentences, and the built site."""

import re
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from docs_site.readme import rows
from suites import docs_scripts
from suites.markdown import Page
from suites.outcome import Outcome
from suites.process import ROOT, run

LONGEST_PAGE = 200  # lines
LONGEST_README = 120
LONGEST_CHANGE = 100  # characters of a line in the changelog
LONGEST_SENTENCE = 25  # words
FOR_NEW_USERS = ["README.md", "docs/get_started.md"]
FETCHED = re.compile(r'<(?:script|img|link rel="stylesheet")[^>]*(?:src|href)="(https?:[^"]*)"')
OPTION = re.compile(r"--[a-z][a-z-]*")


def outcomes() -> Iterator[Outcome]:
    pages = {
        str(path.relative_to(ROOT)): Page(path)
        for path in [*sorted(ROOT.glob("*.md")), *sorted((ROOT / "docs").glob("*.md"))]
    }
    yield lengths(pages)
    yield links(pages)
    yield pictures(pages)
    yield from sentences(pages)
    yield from commands(pages)
    yield from docs_scripts.outcomes(pages)
    yield readme_table()
    yield site()


def lengths(pages: dict[str, Page]) -> Outcome:
    too_long = []
    for name, page in pages.items():
        limit = LONGEST_README if name == "README.md" else LONGEST_PAGE
        if len(page.lines) > limit:
            too_long.append(f"{name} has {len(page.lines)} lines, more than {limit}")
    for number, line in enumerate(pages["CHANGELOG.md"].lines, 1):
        if len(line) > LONGEST_CHANGE:
            too_long.append(f"CHANGELOG.md:{number} has {len(line)} characters, more than {LONGEST_CHANGE}")
    return Outcome.of("docs/no page is too long", not too_long, "\n".join(too_long))


def links(pages: dict[str, Page]) -> Outcome:
    broken = []
    for name, page in pages.items():
        for number, target in page.links():
            path, _, anchor = target.partition("#")
            file = (page.path.parent / path).resolve() if path else page.path
            there = pages.get(str(file.relative_to(ROOT))) if file.is_relative_to(ROOT) else None
            if not file.exists():
                broken.append(f"{name}:{number}: no file {path}")
            elif anchor and (there is None or anchor not in there.anchors()):
                broken.append(f"{name}:{number}: no heading #{anchor} in {path or name}")
    return Outcome.of("docs/every link and picture resolves", not broken, "\n".join(broken))


def pictures(pages: dict[str, Page]) -> Outcome:
    shown = {(page.path.parent / target).resolve() for page in pages.values() for _, target in page.links()}
    unused = [path.name for path in sorted((ROOT / "docs/images").iterdir()) if path not in shown]
    return Outcome.of("docs/every picture is on a page", not unused, "\n".join(unused))


def sentences(pages: dict[str, Page]) -> Iterator[Outcome]:
    long = {name: page.long_sentences(LONGEST_SENTENCE) for name, page in pages.items()}
    for name in FOR_NEW_USERS:
        title = f"docs/no sentence of {name} has more than {LONGEST_SENTENCE} words"
        yield Outcome.of(title, not long[name], "\n".join(f"{name}: {text}" for text in long[name]))
    others = {name: len(found) for name, found in long.items() if found and name not in FOR_NEW_USERS}
    yield Outcome.of(f"docs/{sum(others.values())} sentences of other pages are longer: {others}", True)


def commands(pages: dict[str, Page]) -> Iterator[Outcome]:
    """Every `./steadyhand` of a page uses a verb and options of the help."""
    helps: dict[str, str] = {}
    suites = re.search(r"=~ \^\(unit\|([^)]*)\)\$", (ROOT / "steadyhand").read_text())
    known = {"unit", *(suites[1].split("|") if suites else [])}
    faults, count = [], 0
    for name, page in pages.items():
        for number, verb, arguments in page.commands():
            if verb not in helps:
                status, output = run(["./steadyhand", verb, "--help"])
                helps[verb] = output if status == 0 else ""
            count += 1
            unknown = [word for word in OPTION.findall(arguments) if word not in helps[verb] and word != "--help"]
            unknown += [word for word in arguments.split() if verb == "test" and word not in known]
            if not helps[verb]:
                faults.append(f"{name}:{number}: no verb '{verb}'")
            faults += [f"{name}:{number}: {verb} has no {word}" for word in unknown]
    yield Outcome.of(
        f"docs/{count} commands have a verb and options that exist", count > 0 and not faults, "\n".join(faults)
    )


def readme_table() -> Outcome:
    """Median and worst zero-lag R2 of three made-up trials; a trial without figures does not count."""
    with tempfile.TemporaryDirectory(prefix="steadyhand_docs") as folder:
        results = Path(folder, "real/results.csv")
        results.parent.mkdir()
        lines = ["position,r2_zero_measured,r2_zero_one_euro,r2_zero_synthesised", "unstable,,,", "stable,1,0.9,0.95"]
        lines += [f"unstable,{raw},{raw},{ours}" for raw, ours in ((0.5, 0.9), (0.75, 0.5), (0.1, 0.7))]
        results.write_text("\n".join(lines) + "\n")
        found = rows(Path(folder))
    wanted = [
        ["3", "0.500 / 0.10", "0.500 / 0.10", "0.700 / 0.50"],
        ["1", "1.000 / 1.00", "0.900 / 0.90", "0.950 / 0.95"],
    ]
    return Outcome.of(
        "docs/the README's table has medians and worst trials", [row[1:] for row in found] == wanted, f"{found}"
    )


def site() -> Outcome:
    """Builds the site, and checks that it needs no network."""
    with tempfile.TemporaryDirectory(prefix="steadyhand_docs") as folder:
        command = [sys.executable, "-m", "docs_site", "--out", folder]
        status, output = run(command, PYTHONPATH=str(ROOT / "tools"))
        fetched = []
        for page in Path(folder).rglob("*.html"):
            found = re.findall(
                r'<(?:script|img|link rel="stylesheet")[^>]*(?:src|href)="(https?:[^"]*)"', page.read_text()
            )
            fetched += [f"{page.name} fetches {address}" for address in found]
        good = status == 0 and not fetched and Path(folder, "search/search_index.js").is_file()
    return Outcome.of("docs/the site is built and needs no network", good, "\n".join([output, *fetched]))
