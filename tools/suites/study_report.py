"""./steadyhand study on sessions: counted people, left-out rows, and the report."""

import re
import shutil
import tempfile
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path

from suites import study_statistics
from suites.made_up_sessions import R2, Made, write_session, write_study
from suites.outcome import Outcome
from suites.process import run
from suites.study_faults import bad_rows, bad_session_files, cut_rows, differing_protocols, doubles
from suites.study_folders import SMALL, read, report, rewrite
from suites.study_letters import any_letters


def outcomes() -> Iterator[Outcome]:
    status, output = run(["tools/setup_python.sh", "plots", "signals", "study"])
    yield Outcome.of("command/study report: pingouin is installed", status == 0, output)
    if status != 0:
        return
    yield from study_statistics.outcomes()
    for test in (
        whole_report,
        two_sessions,
        separation,
        left_out_trials,
        answers,
        figure_names,
        any_letters,
        throughput,
        few_values,
        doubles,
        cut_rows,
        bad_rows,
        bad_session_files,
        differing_protocols,
        one_person,
        curves_of_the_median,
        other_inputs,
    ):
        with tempfile.TemporaryDirectory(prefix="steadyhand_report") as folder:
            yield from test(Path(folder))


def whole_report(folder: Path) -> Iterator[Outcome]:
    """The command itself, on nine made-up people with a known effect."""
    write_study(folder / "study", 9)
    status, output = run(["./steadyhand", "study", folder / "study", "--report", folder / "out"])
    yield Outcome.of("command/study report: sound sessions end with 0", status == 0, output)
    if status != 0:
        return
    line = next((line for line in output.splitlines() if " unstable " in line), "")
    wanted = ["made-up data (synthetic)", "horizontal drag", " 9 ", " 108 ", "100 %"]
    yield Outcome.of("command/study report: a short table is printed", all(text in line for text in wanted), output)
    page = (folder / "out/report.html").read_text()
    good = "moving average" in output and "moving average" in page and not re.search(r"\bfilt\b", output + page, re.I)
    yield Outcome.of("command/study report: one name for the moving average", good, output)
    rows = read(folder / "out/drags_synthetic_curves.csv")
    means = {(row["position"], row["curve"]): float(row["r2_mean"]) for row in rows}
    good = all(abs(means[key] - value) < 0.02 for key, value in R2.items())
    yield Outcome.of("command/study report: means of R2 as they were made", good, f"{means}")
    anova = {
        row["effect"]: row
        for row in read(folder / "out/drags_synthetic_anova.csv")
        if row["measure"][:9] == "R² at the"
    }
    good = float(anova["interaction"]["p"]) < 1e-3 and (anova["interaction"]["df1"], anova["interaction"]["df2"]) == (
        "2",
        "16",
    )
    yield Outcome.of("command/study report: the planted interaction is found, F(2, 16)", good, f"{anova}")
    text = (folder / "out/report.html").read_text("utf-8")
    yield from offline_page(text)
    titles = re.findall(r"<(?:h2|h3|caption|summary|figcaption)>(.*?)</", text)
    unnamed = [title for title in titles if "made-up data (synthetic)" not in title]
    good = len(titles) > 10 and not unnamed and "made-up data (synthetic)" in re.search("<title>(.*?)</", text)[1]
    yield Outcome.of("command/study report: every title names made-up data", good, f"{unnamed}")
    figures = text.count("data:image/png;base64,")
    yield Outcome.of("command/study report: three figures: curves, boxes, answers", figures == 3, f"{figures}")


class Tags(HTMLParser):
    """Open tags, and the addresses that a page loads."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.faults: list[str] = []
        self.addresses: list[str] = []

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        if tag not in ("meta", "img"):
            self.open.append(tag)
        self.addresses += [value or "" for name, value in attributes if name in ("src", "href")]

    def handle_endtag(self, tag: str) -> None:
        if not self.open or self.open.pop() != tag:
            self.faults.append(tag)


def offline_page(text: str) -> Iterator[Outcome]:
    tags = Tags()
    tags.feed(text)
    good = not tags.faults and not tags.open
    yield Outcome.of("command/study report: the page's tags are closed", good, f"{tags.faults[:5]} {tags.open}")
    good = all(address.startswith("data:image/png;base64,") for address in tags.addresses) and "http" not in text
    yield Outcome.of("command/study report: the page loads nothing else", good, f"{[a[:60] for a in tags.addresses]}")


def two_sessions(folder: Path) -> Iterator[Outcome]:
    """They are one person, with trials of both, although their trial numbers are the same."""
    for person in ("ann", "bob", "cid"):
        for session in (1, 2):
            write_session(folder / "study", Made(person, session, "person", **SMALL))
    status, output = report(folder / "study", folder / "out")
    rows = read(folder / "out/drags_person_curves.csv")
    counts = {(row["people"], row["trials"]) for row in rows}
    # 3 people x 2 sessions x 3 conditions x 2 repetitions at each position.
    good = status == 0 and counts == {("3", "36")} and "study: " not in output
    yield Outcome.of("command/study report: two sessions are one person, exit 0", good, f"{status} {counts}\n{output}")
    means = read(folder / "out/drags_person_participant_means.csv")
    n = {row["n"] for row in means if row["measure"] == "r2"}
    yield Outcome.of("command/study report: a person's mean is over both sessions", n == {"12"}, f"{n}")


def separation(folder: Path) -> Iterator[Outcome]:
    """What the persons' tables say does not change when made-up data is beside them."""
    write_study(folder / "people", 3, origin="person", **SMALL)
    report(folder / "people", folder / "alone")
    shutil.copytree(folder / "people", folder / "mixed/people")
    flat = dict.fromkeys(R2, 0.5)
    for origin in ("synthetic", "mouse", "replay"):
        write_study(folder / f"mixed/{origin}", 4, origin=origin, r2=flat, seed=9, **SMALL)
    status, output = report(folder / "mixed", folder / "out")
    yield Outcome.of("command/study report: four origins in one folder, exit 0", status == 0, output)
    names = sorted(path.name for path in (folder / "alone").glob("drags_person_*.csv"))
    same = [(folder / "alone" / name).read_bytes() == (folder / "out" / name).read_bytes() for name in names]
    good = len(names) > 8 and all(same)
    yield Outcome.of("command/study report: other origins change no table of persons", good, f"{names} {same}")
    headings = re.findall("<h2>(.*?)</h2>", (folder / "out/report.html").read_text("utf-8"))
    wanted = ["person", "mouse", "made-up data (synthetic)", "replay"]
    good = headings == [f"{label}: study drags" for label in wanted]
    yield Outcome.of("command/study report: one section for each origin, persons first", good, f"{headings}")
    from study.analysis import Analysis
    from study.sessions import read_sessions

    sessions = read_sessions([folder / "mixed"], []).sessions
    try:
        Analysis("drags", "person", sessions, [], [], 0)
        good = False
    except ValueError:
        good = True
    yield Outcome.of("command/study report: an analysis of two origins cannot be made", good)
    path = folder / "mixed/mouse/drags/sub-p01/ses-01/trials.csv"
    path.write_text(path.read_text().replace(",mouse,", ",person,", 1))
    status, output = report(folder / "mixed", folder / "out")
    good = status == 1 and f"{path}:2: origin: 'person' must be 'mouse', as in session.json" in output
    yield Outcome.of("command/study report: a row of another origin is left out", good, f"{status}\n{output}")


def left_out_trials(folder: Path) -> Iterator[Outcome]:
    """Practice never counts; of wrongly recognised trials R2 and T_diff do not."""
    write_study(folder / "study", 3, **SMALL)
    report(folder / "study", folder / "first")
    path = folder / "study/drags/sub-p01/ses-01/trials.csv"
    rows = read(path)
    practice = [row for row in rows if row["practice"] == "1"]
    for row in practice:
        row |= {"r2_measured": "-5.0", "recognised": "", "end_value_m": "9.0"}
    rewrite(path, rows)
    report(folder / "study", folder / "second")
    names = [path.name for path in (folder / "first").glob("*.csv")]
    good = bool(practice) and all(
        (folder / "first" / name).read_bytes() == (folder / "second" / name).read_bytes() for name in names
    )
    yield Outcome.of("command/study report: practice trials change no table", good, f"{len(practice)}")

    first, second = [row for row in rows if row["practice"] == "0" and row["position"] == "stable"][:2]
    first |= {"recognised": "tap", "r2_measured": "-99.0"}
    second |= {"recognised": "", "r2_measured": "-99.0", "end_s": ""}
    rewrite(path, rows)
    status, output = report(folder / "study", folder / "third")
    curves = read(folder / "third/drags_synthetic_curves.csv")
    row = next(row for row in curves if (row["position"], row["curve"]) == ("stable", "measured"))
    good = status == 0 and (row["trials"], row["not_recognised"]) == ("16", "2") and float(row["r2_mean"]) > 0.9
    yield Outcome.of("command/study report: R2 of wrongly recognised trials is left out", good, f"{row}\n{output}")
    row = read(folder / "third/drags_synthetic_recognition.csv")[0]
    good = (row["right"], row["other"], row["none"], row["others"]) == ("16", "1", "1", "tap: 1")
    yield Outcome.of("command/study report: recognition counts right, another and none", good, f"{row}")


def answers(folder: Path) -> Iterator[Outcome]:
    """Means of answers; skipped ones and those after practice trials do not count."""
    write_study(folder / "study", 3, **SMALL)
    path = folder / "study/drags/sub-p01/ses-01/answers.csv"
    rows = read(path)
    asked = next(row for row in rows if row["position"] == "stable" and row["item"] == "smoothness")
    asked |= {"value": "", "skipped": "1"}
    # Trial 1 is practice.
    rows.append(asked | {"after_trial": "1", "value": "0", "skipped": "0"})
    rewrite(path, rows)
    status, output = report(folder / "study", folder / "out")
    table = read(folder / "out/drags_synthetic_answers.csv")
    key = {"item": "paper/smoothness", "position": "stable", "condition": asked["condition"]}
    [row] = [row for row in table if key.items() <= row.items()]
    values = [
        float(one["value"])
        for other in ("p02", "p03")
        for one in read(folder / f"study/drags/sub-{other}/ses-01/answers.csv")
        if (one["item"], one["position"], one["condition"]) == ("smoothness", "stable", asked["condition"])
    ]
    good = (row["people"], row["skipped"]) == ("2", "1") and float(row["mean"]) == sum(values) / 2
    yield Outcome.of("command/study report: skipped and practice answers do not count", good, f"{row} {values}")
    refused = read(folder / "out/drags_synthetic_refused.csv")
    reasons = [row["reason"] for row in refused if row["measure"] == "paper/smoothness" and "ANOVA" in row["test"]]
    good = status == 0 and len(reasons) == 1 and "Participant p01 has no value" in reasons[0]
    yield Outcome.of("command/study report: a skipped answer refuses that item's ANOVA", good, f"{refused}\n{output}")
    rewrite(path, [*rows, rows[0]])
    status, output = report(folder / "study", folder / "out")
    good = status == 1 and f"{path}:{len(rows) + 2}: the same participant, session and trial as {path}:2" in output
    yield Outcome.of("command/study report: an answer twice is named", good, output)


def figure_names(folder: Path) -> Iterator[Outcome]:
    """Each questionnaire has a figure of its own, whatever its name is."""
    write_study(folder / "study", 3, **SMALL)
    names = ["a b", "A_b", "boxes", "é", "ü", "x" * 300]
    for path in sorted(folder.rglob("answers.csv")):
        rewrite(path, [row | {"questionnaire": name} for name in names for row in read(path)])
    status, output = report(folder / "study", folder / "out")
    figures = {path.read_bytes() for path in (folder / "out").glob("drags_synthetic_horizontal_drag_*.png")}
    good = status == 0 and len(figures) == len(names) + 1
    yield Outcome.of("command/study report: questionnaires of any name have a figure each", good, output)


def throughput(folder: Path) -> Iterator[Outcome]:
    """Of one participant as by hand: We = 4.133 SD, IDe = log2(Ae / We + 1), TP = IDe / MT. By --out as by --report."""
    write_study(folder / "study", 1, **SMALL)
    path = folder / "study/drags/sub-p01/ses-01/trials.csv"
    rows = read(path)
    own = [row for row in rows if (row["practice"], row["position"], row["condition"]) == ("0", "stable", "average")]
    # SD of 19 and 21 cm is 1.414214 cm: log2(0.2 / 0.05844944 + 1) = 2.144621 bits in 0.5 s.
    for row, end_m, time_s in zip(own, (0.19, 0.21), (0.4, 0.6), strict=True):
        row |= {"end_value_m": f"{end_m}", "onset_s": "20.0", "end_s": f"{20.0 + time_s}"}
    rewrite(path, rows)
    status, output = run(["./steadyhand", "study", folder / "study", f"--out={folder}/out"])
    table = read(folder / "out/drags_synthetic_throughput.csv") if status == 0 else []
    found = [row for row in table if (row["position"], row["condition"]) == ("stable", "average")]
    good = len(found) == 1 and abs(float(found[0]["throughput_bits_s"]) - 4.289242) < 2e-5
    yield Outcome.of("command/study report: throughput as by hand", good, f"{status} {found}\n{output}")


def few_values(folder: Path) -> Iterator[Outcome]:
    """The report is written whatever is empty."""
    for name, columns in (("no T_diff", ["t_diff"]), ("no reference", ["r2", "r2_zero", "lag", "t_diff"])):
        root = folder / name
        write_study(root / "study", 3, **SMALL)
        for path in root.rglob("trials.csv"):
            empty = {f"{one}_{curve}": "" for one in columns for curve in ("measured", "average", "synthesised")}
            rewrite(path, [row | empty for row in read(path)])
        for path in root.rglob("answers.csv"):
            path.write_text(path.read_text().splitlines()[0] + "\n")
        status, output = report(root / "study", root / "out")
        measures = {row["measure"] for row in read(root / "out/drags_synthetic_anova.csv")}
        wanted = {"throughput (bits/s)"} | ({"R² at the best lag", "R² at zero lag"} if name == "no T_diff" else set())
        # With two trials in a cell a throughput may be missing, and its ANOVA is refused.
        good = status == 0 and wanted - {"throughput (bits/s)"} <= measures <= wanted
        yield Outcome.of(f"command/study report: {name} and no answers, exit 0", good, f"{measures}\n{output}")
    root = folder / "no position"
    write_study(root / "study", 3, **SMALL)
    for path in root.rglob("*.csv"):
        path.write_text(path.read_text().replace(",unstable,", ",,").replace(",stable,", ",,"))
    for path in root.rglob("session.json"):
        path.write_text(path.read_text().replace('"unstable"', '""').replace('"stable"', '""'))
    status, output = report(root / "study", root / "out")
    reasons = {row["reason"] for row in read(root / "out/drags_synthetic_refused.csv")}
    reason = "A two-way ANOVA needs 2 or more levels of the position, and there is only 'none'."
    good = status == 0 and reason in reasons and len(read(root / "out/drags_synthetic_post_hoc.csv")) > 9
    yield Outcome.of("command/study report: no position refuses the ANOVA alone, exit 0", good, f"{reasons}\n{output}")


def one_person(folder: Path) -> Iterator[Outcome]:
    """Tables and figures are there; each test is refused in one sentence. A participant can be left out."""
    write_study(folder / "study", 4, **SMALL)
    status, output = report(folder / "study", folder / "out", "p02", "p03", "p04")
    reasons = {row["reason"] for row in read(folder / "out/drags_synthetic_refused.csv")}
    good = status == 0 and reasons == {"The test needs 3 or more people, and there is data of 1 person."}
    yield Outcome.of("command/study report: one person gives tables, tests are refused", good, f"{reasons}\n{output}")
    yield Outcome.of("command/study report: --without is noted", "participant p03 is left out" in output, output)
    status, output = report(folder / "study", folder / "out", "p09")
    good = status == 1 and "--without p09: no session is of this participant" in output
    yield Outcome.of("command/study report: --without an unknown participant is named", good, output)


def curves_of_the_median(folder: Path) -> Iterator[Outcome]:
    from study.analysis import split
    from study.curve_figure import choose
    from study.sessions import read_sessions

    write_study(folder / "study", 3, repetitions=3)
    rows = [row for path in folder.rglob("trials.csv") for row in read(path)]
    rows = [row for row in rows if row["position"] == "unstable" and row["practice"] == "0"]
    middle = sorted(float(row["r2_synthesised"]) for row in rows)[(len(rows) - 1) // 2]
    chosen = choose(split(read_sessions([folder / "study"], []))[0])
    good = abs(chosen.trial.figures["r2_synthesised"] - middle) < 1e-12 and chosen.of == len(rows)
    yield Outcome.of("command/study report: curves are of the median trial", good, f"{chosen}")
    lines = chosen.path.read_text().splitlines(keepends=True)
    lines[4] = lines[4].replace(lines[4].split(",")[1], "x", 1)
    chosen.path.write_text("".join(lines))
    status, output = report(folder / "study", folder / "out")
    good = status == 1 and f"{chosen.path}:5: measured: 'x' is not a number" in output
    yield Outcome.of(
        "command/study report: a bad curve is named, the other figures are made", good, f"{status}\n{output}"
    )
    for path in folder.rglob("*.motion.csv"):
        path.unlink()
    status, output = report(folder / "study", folder / "out")
    text = (folder / "out/report.html").read_text("utf-8")
    good = status == 0 and "there are no curves to draw" in text and not list((folder / "out").glob("*curves.png"))
    yield Outcome.of("command/study report: without curves there is a note", good, f"{status}\n{output}")


def other_inputs(folder: Path) -> Iterator[Outcome]:
    write_study(folder / "study", 1, **SMALL)
    (folder / "file").touch()
    status, output = report(folder / "study", folder / "file")
    good = status == 2 and f"study: {folder}/file: this is a file: name a folder" in output
    yield Outcome.of("command/study report: OUT that is a file ends with 2", good, f"{status}\n{output}")
    for path in folder.rglob("trials.csv"):
        path.write_text(path.read_text().splitlines()[0] + "\n")
    status, output = report(folder / "study", folder / "out")
    good = status == 2 and "no trial that counts" in output and not (folder / "out").exists()
    yield Outcome.of("command/study report: no trial at all ends with 2", good, f"{status}\n{output}")
