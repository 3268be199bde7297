"""Tables of the statistical tests."""

from study.inference import Results
from study.measures import CURVE_MEASURES
from study.tables import Column, Table, decimals, probability, spoken, with_titles

OF = [Column("measure", "Measure"), Column("gesture", "Gesture", spoken)]
PEOPLE = Column("people", "People")

NORMALITY_NOTE = (
    "Participants' means in each cell. Shapiro-Wilk, and the one-sample Kolmogorov-Smirnov test of the paper, with the"
    " mean and SD of the sample itself. That makes its p too large; trust Shapiro-Wilk where they differ."
)
ANOVA_NOTE = (
    "Two-way repeated-measures ANOVA of participants' means: position x motion profile. Where an effect has more than"
    " one degree of freedom, p (GG) is corrected by the Greenhouse-Geisser epsilon."
)
POST_HOC_NOTE = (
    "Paired t-tests. The Bonferroni p is p times the number of comparisons of this measure and gesture, at most 1."
    " Cohen's d: the difference over the root mean square of both SDs; d_z: over the SD of the differences."
)
FRIEDMAN_NOTE = (
    "Friedman's test stands beside the ANOVA, because answers on a scale are ordinal: steps need not be equal, and"
    " values are few and bounded, so a normal distribution is doubtful. It uses ranks only. It tests the motion"
    " profiles in each position; it has no interaction."
)
REFUSED_NOTE = "These tests were not computed, because the data does not allow them. All other tests were."


def collected(of: list[Results], kind: str) -> list[dict]:
    return [{"measure": name_of(one.measure), "gesture": one.gesture} | row for one in of for row in getattr(one, kind)]


def name_of(measure: str) -> str:
    return {**CURVE_MEASURES, "throughput": "throughput (bits/s)"}.get(measure, measure)


def anova_table(of: list[Results]) -> Table:
    columns = [
        *OF,
        Column("effect", "Effect"),
        PEOPLE,
        Column("df1", "df 1"),
        Column("df2", "df 2"),
        Column("f", "F", decimals(2)),
        Column("p", "p", probability),
        Column("gg_epsilon", "GG epsilon", decimals(3)),
        Column("p_gg", "p (GG)", probability),
        Column("generalised_eta2", "generalised η²", decimals(3)),
        Column("partial_eta2", "partial η²", decimals(3)),
    ]
    return Table("anova", "Two-way repeated-measures ANOVA", columns, collected(of, "anova"), ANOVA_NOTE)


def post_hoc_table(of: list[Results]) -> Table:
    columns = [
        *OF,
        Column("a", "A", with_titles),
        Column("b", "B", with_titles),
        PEOPLE,
        Column("difference", "A - B", decimals(4)),
        Column("t", "t", decimals(2)),
        Column("df", "df"),
        Column("p", "p", probability),
        Column("comparisons", "Comparisons"),
        Column("p_bonferroni", "p (Bonferroni)", probability),
        Column("cohen_d", "d", decimals(2)),
        Column("cohen_dz", "d_z", decimals(2)),
    ]
    return Table("post_hoc", "Post hoc t-tests", columns, collected(of, "post_hoc"), POST_HOC_NOTE, folded=True)


def normality_table(of: list[Results]) -> Table:
    columns = [
        *OF,
        Column("position", "Position"),
        Column("motion", "Motion or condition", with_titles),
        Column("n", "People"),
        Column("mean", "Mean", decimals(4)),
        Column("sd", "SD", decimals(4)),
        Column("shapiro_w", "W", decimals(3)),
        Column("shapiro_p", "p (Shapiro-Wilk)", probability),
        Column("ks_d", "D", decimals(3)),
        Column("ks_p", "p (KS)", probability),
    ]
    return Table("normality", "Normality", columns, collected(of, "normality"), NORMALITY_NOTE, folded=True)


def friedman_table(of: list[Results]) -> Table:
    columns = [
        *OF,
        Column("position", "Position"),
        PEOPLE,
        Column("df", "df"),
        Column("q", "Q", decimals(2)),
        Column("p", "p", probability),
        Column("kendall_w", "Kendall's W", decimals(3)),
    ]
    return Table("friedman", "Friedman's test of the answers", columns, collected(of, "friedman"), FRIEDMAN_NOTE)


def refused_table(of: list[Results]) -> Table:
    columns = [*OF, Column("test", "Test"), Column("reason", "Reason")]
    # One row for each reason, so that a study with two people does not fill pages.
    rows: dict[tuple[str, str, str], list[str]] = {}
    for row in collected(of, "refused"):
        rows.setdefault((row["measure"], row["gesture"], row["reason"]), []).append(row["test"])
    grouped = [
        {"measure": measure, "gesture": gesture, "test": "; ".join(names), "reason": reason}
        for (measure, gesture, reason), names in rows.items()
    ]
    return Table("refused", "Refused tests", columns, grouped, REFUSED_NOTE)


def statistics_tables(of: list[Results]) -> list[Table]:
    return [anova_table(of), post_hoc_table(of), friedman_table(of), normality_table(of), refused_table(of)]


def stars(p: float) -> str:
    """As in the paper's Fig. 7: ** p < 0.001, * p < 0.05."""
    return "**" if p < 0.001 else "*" if p < 0.05 else ""
