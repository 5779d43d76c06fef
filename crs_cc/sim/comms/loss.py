"""Loss of messages: independently, or in bursts.

A receiver is in one of two states on each channel, and takes a step with each message that reaches
it (E. N. Gilbert, "Capacity of a burst-noise channel", 1960; E. O. Elliott, "Estimates of error
rates for codes on burst-noise channels", 1963):

    good -> bad with probability p (burst-begin),   bad -> good with probability r (burst-end)

and then the message is lost with probability `loss` in the good state, `burst-loss` in the bad one.
In the long run the share p / (p + r) of messages meets the bad state, in bursts of 1 / r messages
on average.
"""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray


def burst_states(
    bad: BoolArray, chain: IndexArray, chance: FloatArray, begin: FloatArray, end: FloatArray
) -> BoolArray:
    """Return the state that each message meets, and advance the chains by one step per message.

    One random number decides a step from either state: below p it leads from good to bad, from
    1 - r on it leads from bad to good. So a step sets the state, keeps it, or (with p + r > 1)
    inverts it, and the state after many steps follows from the last step that set it and the
    number of inversions since: no loop over messages.

    Args:
        bad: the states of all chains, changed in place.
        chain: the chain of each message, sorted, equal ones by time, shape (k,).
        chance: a random number for each.
        begin: its p.
        end: its r.

    Returns:
        whether each meets the bad state, shape (k,).

    >>> states = np.array([False, True])
    >>> chance, p, r = np.array([0.05, 0.5, 0.95, 0.5]), np.full(4, 0.1), np.full(4, 0.2)
    >>> burst_states(states, np.array([0, 0, 0, 1]), chance, p, r), states
    (array([ True,  True, False,  True]), array([False,  True]))
    """
    if not len(chain):
        return np.zeros(0, dtype=np.bool_)
    from_good, from_bad = chance < begin, chance < 1.0 - end
    sets, turns = from_good == from_bad, from_good & ~from_bad
    place = np.arange(len(chain))
    starts = np.concatenate([[True], chain[1:] != chain[:-1]])
    first = np.maximum.accumulate(np.where(starts, place, 0))
    last_set = np.maximum.accumulate(np.where(sets, place, -1))
    is_set = last_set >= first
    turned = np.cumsum(turns)
    since = np.where(is_set, turned[last_set], turned[first] - turns[first])
    base = np.where(is_set, from_good[last_set], bad[chain])
    found = base ^ ((turned - since) % 2 == 1)
    ends = np.concatenate([starts[1:], [True]])
    bad[chain[ends]] = found[ends]
    return np.asarray(found)
