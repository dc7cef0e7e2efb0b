# SPDX-License-Identifier: MIT
"""The time of the orthogonal distance fit against that of Schneider's, and the segments that it saves."""

from ..bundle import Missing
from ..document import Finding
from ..time_tables import fits_with_times
from ..wording import count, factor, general, shortest

SUITE = "companion_speed"
METHOD, OTHER = "gauss_newton", "schneider"


def find(bundle):
    """Holds where the orthogonal distance fit takes longer in every race, by the interval of the paired ratio."""
    pairs = fits_with_times(bundle)
    races = [(time.number("ratio"), time, fit) for time, fit in pairs
             if time["method"] == METHOD and time["relative_to"] == OTHER and time["ratio"] is not None]
    if not races:
        raise Missing(f"`timing.csv` has no ratio of `{METHOD}` to `{OTHER}`")

    def other(time):
        return next(fit for t, fit in pairs if t["method"] == OTHER and all(t[c] == time[c] for c in ("data", "tolerance")))

    def words(ratio, time, fit):
        return (f"{factor(ratio)} times the time for {general(fit.number('mean_segments'))} segments in place of "
                f"{general(other(time).number('mean_segments'))} (`{time['data']}`, tolerance {shortest(time['tolerance'])})")
    slower = [race for race in races if race[1].number("ratio_low") > 1]
    least, most = min(races, key=lambda r: r[0]), max(races, key=lambda r: r[0])
    holds = len(slower) == len(races)
    fewer = sum(fit.number("mean_segments") < other(time).number("mean_segments") for _, time, fit in races)
    return Finding(
        id="fitting_time", about="suite", suite=SUITE, claim="", holds=holds,
        headline=f"To fit orthogonal distances takes {factor(least[0])} to {factor(most[0])} times as long as Schneider's fit."
        if holds else
        f"To fit orthogonal distances takes longer than Schneider's fit in only {len(slower)} of {count(len(races), 'race')}.",
        detail=(f"At the least {words(*least)}, at the most {words(*most)}. It needs fewer segments in {fewer} of "
                f"{count(len(races), 'race')}, a race for each kind of data and tolerance.",),
        rows=tuple(row for _, time, fit in (least, most) for row in (time, fit, other(time))))
