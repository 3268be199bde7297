"""One analysis for each study and origin, so that persons and made-up data never mix."""

from dataclasses import dataclass, field

from study.session_file import ORIGINS, Session, differences
from study.session_rows import Answer, StudyTrial
from study.sessions import Sessions


@dataclass(frozen=True)
class Analysis:
    study: str
    origin: str
    sessions: list[Session]
    trials: list[StudyTrial]  # without practice
    answers: list[Answer]  # without those after practice trials
    practice: int  # number of practice trials
    notes: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        owners = [*self.sessions, *(row.session for row in (*self.trials, *self.answers))]
        if any((one.study, one.origin) != (self.study, self.origin) for one in owners):
            raise ValueError("an analysis has rows of one study and one origin only")
        if any(trial.practice for trial in self.trials):
            raise ValueError("an analysis has no practice trials")

    @property
    def label(self) -> str:
        """Part of the title of every section, table and figure."""
        return ORIGINS[self.origin]

    @property
    def participants(self) -> list[str]:
        return sorted({session.participant for session in self.sessions})

    @property
    def gestures(self) -> list[str]:
        return sorted({trial.gesture for trial in self.trials})


def split(read: Sessions) -> list[Analysis]:
    """Persons first."""
    order = list(ORIGINS)
    keys = {(session.study, session.origin) for session in read.sessions}
    return [one_analysis(read, *key) for key in sorted(keys, key=lambda key: (key[0], order.index(key[1])))]


def one_analysis(read: Sessions, study: str, origin: str) -> Analysis:
    def own(rows: list) -> list:
        return [row for row in rows if (row.session.study, row.session.origin) == (study, origin)]

    sessions = [session for session in read.sessions if (session.study, session.origin) == (study, origin)]
    trials = own(read.trials)
    answers = [answer for answer in own(read.answers) if not after_practice(answer)]
    counted = [trial for trial in trials if not trial.practice]
    notes = [*differing_sessions(sessions), *mixed_references(counted), *answers_without_condition(answers)]
    return Analysis(study, origin, sessions, counted, answers, len(trials) - len(counted), notes)


def after_practice(answer: Answer) -> bool:
    planned = answer.session.plan.get(answer.after_trial)
    return planned is not None and planned.practice


def differing_sessions(sessions: list[Session]) -> list[str]:
    """Sessions of different protocols, settings or versions may not be comparable."""
    return [
        f"Sessions differ in {kind} {one}."
        for kind, key in (("protocol", "protocol"), ("setting", "settings"), ("version", "versions"))
        for one in differences([getattr(session, key) for session in sessions])
    ]


def mixed_references(trials: list[StudyTrial]) -> list[str]:
    kinds = sorted({trial.reference for trial in trials} - {""})
    return [f"Trials have different references: {', '.join(kinds)}."] if len(kinds) > 1 else []


def answers_without_condition(answers: list[Answer]) -> list[str]:
    count = sum(not answer.condition for answer in answers)
    return [f"{count} answers belong to no condition: no table or test has them."] if count else []
