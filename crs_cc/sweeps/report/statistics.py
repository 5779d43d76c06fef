"""Statistics of the results of runs, by scipy (extra `analysis`).

What is measured over seeds is rarely normal: times have long tails, and end where runs do. So all
of it is by ranks: medians, bootstrapped intervals, and tests that compare ranks.

>>> found = summary([1.0, 2.0, 3.0, 4.0, 50.0])
>>> found.n, found.median, found.low_quartile, found.high_quartile
(5, 3.0, 2.0, 4.0)
>>> compared = comparison([1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 8.0])
>>> compared.effect, round(compared.p, 3), compared.needed
(-1.0, 0.029, 6)
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

_RESAMPLES: Final = 5000
_SEED: Final = 1
_ALPHA: Final = 0.05
_POWER: Final = 0.8


@dataclass(frozen=True, slots=True)
class Summary:
    """A measure over the seeds.

    Attributes:
        n: how many values there are.
        median: the median.
        low_quartile: a quarter is below.
        high_quartile: a quarter is above.
        low: the lower end of the bootstrapped 95% interval of the median.
        high: its upper end.
    """

    n: int
    median: float
    low_quartile: float
    high_quartile: float
    low: float
    high: float


def summary(values: Sequence[float]) -> Summary:
    """Return the summary of values, of which there is at least one."""
    from scipy.stats import bootstrap

    array = np.array(values, np.float64)
    low_quartile, median, high_quartile = (float(each) for each in np.quantile(array, _QUARTILES))
    low = high = median
    if len(np.unique(array)) > 1:
        interval = bootstrap(
            (array,),
            np.median,
            n_resamples=_RESAMPLES,
            method="percentile",
            rng=np.random.default_rng(_SEED),
        ).confidence_interval
        low, high = float(interval.low), float(interval.high)
    return Summary(len(array), median, low_quartile, high_quartile, low, high)


_QUARTILES: Final = (0.25, 0.5, 0.75)


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two groups of values.

    Attributes:
        p: the probability of such a difference by chance (Mann-Whitney U test, two-sided).
        effect: Cliff's delta: how much more often a value of the first group is larger than one of
            the second than smaller, -1 to 1.
        needed: how many values each group needs to show such an effect in four of five cases, see
            `required_sample_size`.
    """

    p: float
    effect: float
    needed: int | None


def comparison(first: Sequence[float], second: Sequence[float]) -> Comparison:
    """Return the comparison of two groups."""
    from scipy.stats import mannwhitneyu

    found = mannwhitneyu(first, second)
    effect = 2.0 * float(found.statistic) / (len(first) * len(second)) - 1.0
    return Comparison(float(found.pvalue), effect, required_sample_size(effect))


def required_sample_size(effect: float) -> int | None:
    """Return the sample size per group that shows an effect with a power of 80%.

    The formula is Noether's for the Mann-Whitney test (Sample size determination for some common
    nonparametric tests, 1987, JASA 82, 645-647), with half of the values in each group.

    >>> required_sample_size(0.5), required_sample_size(0.0)
    (21, None)
    """
    from scipy.stats import norm

    if effect == 0.0:
        return None
    z = float(norm.isf(_ALPHA / 2.0) + norm.ppf(_POWER))
    shift = abs(effect) / 2.0  # of the probability to be larger, from one half
    return math.ceil(z * z / (6.0 * shift * shift))


def adjusted_p_values(p: Sequence[float]) -> list[float]:
    """Return the probabilities of several tests, corrected for their number (Benjamini-Hochberg).

    >>> adjusted_p_values([0.01, 0.04])
    [0.02, 0.04]
    """
    from scipy.stats import false_discovery_control

    return [float(each) for each in false_discovery_control(p)] if p else []


def kruskal_wallis_p(groups: Sequence[Sequence[float]]) -> float:
    """Return the p-value of the Kruskal-Wallis test for differences between groups."""
    from scipy.stats import kruskal

    if len({value for group in groups for value in group}) < 2:
        return 1.0
    return float(kruskal(*groups).pvalue)


@dataclass(frozen=True, slots=True)
class Survival:
    """The share of runs in which something has not happened yet (Kaplan-Meier estimate).

    Attributes:
        times: when it changes.
        shares: the share from then on.
        low: the lower end of its 95% interval.
        high: its upper end.
    """

    times: tuple[float, ...]
    shares: tuple[float, ...]
    low: tuple[float, ...]
    high: tuple[float, ...]


def survival(times: Sequence[float], ended: Sequence[float]) -> Survival:
    """Return the survival function of times.

    Args:
        times: when it happened.
        ended: when runs ended in which it did not.
    """
    from scipy.stats import CensoredData, ecdf

    found = ecdf(CensoredData(uncensored=list(times), right=list(ended))).sf
    quantiles, shares = found.quantiles, found.probabilities
    with warnings.catch_warnings():  # at its ends it has no interval
        warnings.simplefilter("ignore", RuntimeWarning)
        interval = found.confidence_interval(method="log-log")
    low, high = (
        np.where(np.isfinite(each.probabilities), each.probabilities, shares)
        for each in (interval.low, interval.high)
    )
    return Survival(*(tuple(map(float, each)) for each in (quantiles, shares, low, high)))
