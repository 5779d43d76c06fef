"""`crs_tag` from C: what is near is hot no more."""

import pytest

from tests.nclient.drive import drive


@pytest.mark.function("crs_tag")
def test_it_takes_the_heat_from_what_is_near_and_counts_it():
    """A Scout's reach is 3 m: it takes the heat of two of the three, and then of none."""
    things = '<robot x="0" y="0"/>' + "".join(
        f'<cylinder x="{x}m" y="0" radius="20cm" heat="5"/>' for x in (1, -2, 4)
    )
    ask = 'int heat; crs_heat(&heat); printf("%d %d ", heat, crs_tag()); printf("%d ", crs_tag());'
    show = 'crs_heat(&heat); printf("%d\\n", heat);'
    assert drive(ask + show, things=things).numbers == [10, 2, 0, 0]
