"""What each part of `phase` mode is worth: the estimator rebuilt with one thing changed, on the same trials.

    python tools/tuning/variants.py --out DIR [--trials DIR]... [--variant PART_OF_A_NAME]
    python tools/tuning/variants.py --check

Builds what tools/tuning/variants.toml lists in a copy of the sources, in the cache, and runs each on synthetic
people of the tuning population and on each of the trial sets. Writes variants.csv (one row a trial and variant)
and table.md: by how many thousandths the mean R2 at no lag differs from that of the sources as they are, on the
same trials, with the standard error of that difference as if trials were independent; and, by set, how many of a
hundred stable trials end within the bounds of T_diff. --check: only whether each change still fits the sources.
"""

import argparse
import csv
import io
import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from results.asked import is_inside

ROOT = Path(__file__).resolve().parents[2]
CORE = Path("extension/core")
SOURCES = ["SConstruct", "extension/core", "models", "tests", "tools"]
PROGRAM = "bench_accuracy"
AS_IT_IS = "as it is"
SYNTHETIC = "synthetic"


def read_variants() -> dict[str, list[dict]]:
    listed = tomllib.loads((ROOT / "tools/tuning/variants.toml").read_text())["variant"]
    return {variant["name"]: variant["edits"] for variant in listed}


def edited(text: str, edit: dict) -> str:
    if (count := text.count(edit["old"])) != 1:
        raise ValueError(f"{edit['file']} has {count} times, not once: {edit['old']}")
    return text.replace(edit["old"], edit["new"])


def cache() -> Path:
    """As tools/shell.sh has it."""
    if own := os.environ.get("STEADYHAND_CACHE"):
        return Path(own)
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "steadyhand"


def edited_files(place: Path, edits: list[dict]) -> dict[Path, str]:
    """By file the new text, of the sources at place. Raises ValueError where an edit does not fit them."""
    texts = {}
    for edit in edits:
        file = place / CORE / edit["file"]
        texts[file] = edited(texts.get(file) or file.read_text(), edit)
    return texts


def check() -> None:
    for edits in read_variants().values():
        edited_files(ROOT, edits)


def copy_sources(place: Path) -> None:
    for source in SOURCES:
        shutil.rmtree(place / source, ignore_errors=True)
        if (ROOT / source).is_dir():
            shutil.copytree(ROOT / source, place / source)
        else:
            place.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / source, place / source)


def measure(place: Path, sets: dict[str, Path | None]) -> dict[str, list[dict[str, str]]]:
    subprocess.run(["scons", "-Q", "-s", "target=template_release", PROGRAM], cwd=place, check=True, stdout=sys.stderr)
    program = place / "build/template_release/bench" / PROGRAM

    def rows(trials: Path | None) -> list[dict[str, str]]:
        command = [program, place / "models", *([trials] if trials else [])]
        return list(
            csv.DictReader(io.StringIO(subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE).stdout))
        )

    return {name: rows(trials) for name, trials in sets.items()}


def measure_variant(place: Path, edits: list[dict], sets: dict[str, Path | None]) -> dict[str, list[dict[str, str]]]:
    changed = edited_files(place, edits)
    before = {file: file.read_text() for file in changed}
    try:
        for file, text in changed.items():
            file.write_text(text)
        return measure(place, sets)
    finally:
        for file, text in before.items():
            file.write_text(text)


def column(rows: list[dict[str, str]], name: str, position: str) -> np.ndarray:
    return np.array([float(row[name]) for row in rows if row["position"] == position])


def gain(rows: list[dict[str, str]], base: list[dict[str, str]], position: str) -> str:
    thousandths = 1000.0 * (column(rows, "r2_zero", position) - column(base, "r2_zero", position))
    return f"{thousandths.mean():+.1f} ± {thousandths.std(ddof=1) / np.sqrt(len(thousandths)):.1f}"


def together(sets: dict[str, list[dict[str, str]]]) -> list[dict[str, str]]:
    return [row for rows in sets.values() for row in rows]


def ends(sets: dict[str, list[dict[str, str]]]) -> str:
    rows = together(sets)
    off_s = np.abs(column(rows, "t_diff_s", "unstable")).mean()
    inside = [np.mean([is_inside(t, "stable") for t in column(of, "t_diff_s", "stable")]) for of in sets.values()]
    shares = ", ".join(f"{100.0 * share:.0f}" for share in inside)
    return f"{shares} | {1000.0 * off_s:.0f} ms | {sum(int(row['missed']) for row in rows)}"


def table(results: dict[str, dict[str, list[dict[str, str]]]]) -> str:
    base = results[AS_IT_IS]
    head = [*(f"{name}, unstable" for name in base), "stable, all"]
    means = [column(rows, "r2_zero", "unstable").mean() for rows in base.values()]
    means.append(column(together(base), "r2_zero", "stable").mean())
    lines = [
        f"| what is changed | {' | '.join(head)} | stable ends inside, % | size of T_diff, unstable | missed |",
        "| --- |" + " ---: |" * (len(head) + 3),
        f"| nothing: mean R2 at no lag | {' | '.join(f'{mean:.4f}' for mean in means)} | {ends(base)} |",
    ]
    for name, sets in results.items():
        if name != AS_IT_IS:
            cells = [gain(rows, base[of], "unstable") for of, rows in sets.items()]
            cells.append(gain(together(sets), together(base), "stable"))
            lines.append(f"| {name} | {' | '.join(cells)} | {ends(sets)} |")
    return "\n".join(lines) + "\n"


def write_rows(file: Path, results: dict[str, dict[str, list[dict[str, str]]]]) -> None:
    with file.open("w", newline="") as out:
        rows = [{"variant": v, "set": s} | row for v, sets in results.items() for s, of in sets.items() for row in of]
        writer = csv.DictWriter(out, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    wanted = parser.add_mutually_exclusive_group(required=True)
    wanted.add_argument("--out", type=Path)
    wanted.add_argument("--check", action="store_true")
    parser.add_argument("--trials", type=Path, action="append", default=[])
    parser.add_argument("--variant", default="", help="only those with this in their name")
    given = parser.parse_args()
    for folder in given.trials:
        if not (folder / "trials.csv").is_file():
            sys.exit(f"{folder}: no trial set (trials.csv)")
    try:
        check()
    except ValueError as error:
        sys.exit(f"tools/tuning/variants.toml: {error}")
    if given.check:
        return
    variants = {name: edits for name, edits in read_variants().items() if given.variant in name}
    place = cache() / "variants"
    copy_sources(place)
    sets = {SYNTHETIC: None} | {folder.name: folder.resolve() for folder in given.trials}
    given.out.mkdir(parents=True, exist_ok=True)
    results = {}
    for i, (name, edits) in enumerate({AS_IT_IS: [], **variants}.items()):
        print(f"{i + 1} of {1 + len(variants)}: {name}", file=sys.stderr, flush=True)
        results[name] = measure_variant(place, edits, sets)
        (given.out / "table.md").write_text(table(results))
    write_rows(given.out / "variants.csv", results)
    print(given.out / "table.md")


if __name__ == "__main__":
    main()
