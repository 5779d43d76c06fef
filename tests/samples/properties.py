"""What must be true of a run of each sample, whatever the numbers are to the last digit."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from tests.samples.driving import INCH_M, Drive


def touches_nothing(drive: Drive) -> None:
    assert [robot.collisions for robot in drive.robots] == [0] * len(drive.robots)


def meets_all_goals(drive: Drive) -> None:
    assert [goal.status for goal in drive.goals] == ["met"] * 3


def gets_about(drive: Drive) -> None:
    touches_nothing(drive)
    assert drive.robot.distance_m > 5
    assert drive.squares(0.5) > 10


def all_kinds_get_about(drive: Drive) -> None:
    """The Nomad leaves after 30 s, the second AmigoBot comes after 10 s."""
    touches_nothing(drive)
    assert all(robot.distance_m > 4 for robot in drive.robots)
    outcomes = {robot.id: robot.outcome for robot in drive.robots}
    assert outcomes.pop("nomad") == "left"
    assert set(outcomes.values()) == {"exited"}
    assert [robot.joined_s for robot in drive.robots] == [0.0, 0.0, 0.0, 0.0, 10.0]


def closes_its_square(drive: Drive) -> None:
    touches_nothing(drive)
    assert np.hypot(*(drive.places[-1] - drive.places[0])) < 0.07
    assert drive.robot.distance_m == pytest.approx(4 * 40 * INCH_M, rel=0.01)
    x_m, y_m = drive.places.T
    area_m2 = 0.5 * np.sum(x_m * np.roll(y_m, -1) - y_m * np.roll(x_m, -1))
    assert area_m2 == pytest.approx((40 * INCH_M) ** 2, rel=0.05)
    (error_in,) = drive.numbers(r"error of closure (.*) in")
    assert error_in < 3


def bumps_into_the_stove(drive: Drive) -> None:
    """The stove of `worlds/stove.xml` is the only thing that robots can touch from their start."""
    assert drive.robot.collisions >= 1
    x_m, y_m = drive.places[-1]
    assert math.hypot(x_m + 0.5, y_m + 2) == pytest.approx(0.6 + 8 * INCH_M, abs=0.01)


def counts_the_doors(drive: Drive) -> None:
    """The places are those of `worlds/corridor.xml`, 30 in less: where the robot starts."""
    touches_nothing(drive)
    pattern = r"(left|right) +(\S+) to +(\S+) in +(\w+)"
    found = [
        (side, kind, float(start), float(end))
        for side, start, end, kind in re.findall(pattern, drive.text)
        if kind != "gap"
    ]
    doors = {
        ("left", "door"): [(60, 96), (300, 336)],
        ("left", "passage"): [(156, 240)],
        ("right", "door"): [(110, 146), (192, 228), (366, 402)],
    }
    assert {(side, kind) for side, kind, _, _ in found} == set(doors)
    for key, places in doors.items():
        seen = [(start, end) for side, kind, start, end in found if (side, kind) == key]
        assert np.array(seen) == pytest.approx(np.array(places), abs=4)


def arrives_untouched(drive: Drive) -> None:
    touches_nothing(drive)
    (x_in, y_in, off_in) = drive.numbers(r"arrived at \((\S+), (\S+)\), (\S+) in from the goal")
    assert off_in < 6
    assert drive.places[-1] - drive.places[0] == pytest.approx(
        [x_in * INCH_M, y_in * INCH_M], abs=0.25
    )


def uses_its_behaviours(drive: Drive) -> None:
    touches_nothing(drive)
    assert drive.squares(0.5) > 10
    shares = {
        name: float(share)
        for name, share in re.findall(r"^(\w+) +(\S+) %", drive.text, re.MULTILINE)
    }
    assert shares.keys() == {"escape", "avoid", "veer", "explore", "cruise"}
    assert all(shares[name] > 1 for name in ("avoid", "veer", "explore", "cruise"))
    assert sum(shares.values()) == pytest.approx(100, abs=0.3)


def bounces(drive: Drive) -> None:
    assert drive.robot.collisions == 12
    assert len(re.findall(r"^contact +\d+  \[\.*#[.#]*\]", drive.text, re.MULTILINE)) == 12
    assert drive.squares(0.5) > 15


def drives_an_eight(drive: Drive) -> None:
    """Two circles of 30 in, to the left and to the right, in a loop of 100 ms."""
    assert np.ptp(drive.places, axis=0) / INCH_M == pytest.approx([60, 120], abs=2)
    assert drive.robot.distance_m / INCH_M == pytest.approx(4 * np.pi * 30, rel=0.02)
    missed, mean_ms, least_ms, most_ms = drive.numbers(
        r"(\d+) missed; period (\S+) ms, .* from (\S+) to (\S+)"
    )
    assert missed == 0
    assert mean_ms == pytest.approx(100, abs=0.1)
    assert 99 < least_ms <= most_ms < 101


def draws_the_studio(drive: Drive) -> None:
    """The cells of the map are those of `worlds/studio.xml`."""
    touches_nothing(drive)
    free, full = [], []
    for y, row in re.findall(r"^ *(\S+) \|(.*)\|$", drive.text, re.MULTILINE):
        for column, mark in enumerate(row):
            place = (40 - 60 + 5 * (column + 0.5), 35 + float(y))
            (free if mark in ".+" else full if mark == "#" else []).append(place)
    assert np.mean([to_wall_in(*place) > -5 for place in free]) > 0.98
    assert np.mean([abs(to_wall_in(*place)) < 10 for place in full]) > 0.9
    assert len(free) * 25 > 0.75 * (200 * 150 - 70 * 55 - 16 * 16 - 20 * 40)


def to_wall_in(x_in: float, y_in: float) -> float:
    """Return the distance from the nearest thing of the studio [in], below 0 inside of one."""
    nearest = min(x_in, 200 - x_in, y_in, 150 - y_in)
    for left, right, low, high in [(130, 200, 95, 150), (72, 88, 72, 88), (0, 20, 80, 120)]:
        dx, dy = max(left - x_in, x_in - right), max(low - y_in, y_in - high)
        outside = float(np.hypot(max(dx, 0), max(dy, 0)))
        nearest = min(nearest, outside or max(dx, dy))
    return nearest


def finds_itself(drive: Drive) -> None:
    touches_nothing(drive)
    errors = np.array(re.findall(r"(\S+) in +(\S+) deg +(\S+) in", drive.text), dtype=float)
    assert errors[0, 0] > 20
    assert (errors[-5:, 0] < 6).all()
    assert (abs(errors[-5:, 1]) < 10).all()
    x_in, y_in, heading_deg = map(float, drive.text.splitlines()[-1].split("%")[1].split()[:3])
    assert [x_in, y_in] == pytest.approx(drive.places[-1] / INCH_M, abs=0.2)
    assert np.cos(np.radians(heading_deg) - drive.robot.pose[2]) > 0.999


def arrives_at_its_goal(drive: Drive) -> None:
    touches_nothing(drive)
    (off_in,) = drive.numbers(r"arrived (\S+) in from the goal")
    goal = np.array([413, 260])
    assert np.hypot(*(drive.places[-1] / INCH_M - goal)) == pytest.approx(off_in, abs=2)
    assert off_in < 8


def finds_two_doors_open(drive: Drive) -> None:
    """The doors are those of `worlds/night.xml`."""
    touches_nothing(drive)
    states = re.findall(r"(OPEN|closed) +nothing for", drive.text)
    assert states == ["OPEN", "closed", "closed", "OPEN"]
    assert "4 doors, 2 open, 2 closed\n" in drive.text
    assert np.hypot(*(drive.places[-1] - drive.places[0])) < 12 * INCH_M


def reads_what_it_wrote(drive: Drive) -> None:
    touches_nothing(drive)
    rows = drive.files["drive.log"].decode().splitlines()[1:]
    log = np.array([row.split() for row in rows], dtype=float)
    assert log.shape == (400, 7 + 16)
    assert (np.diff(log[:, 0]) > 0.1).all()
    turned = np.radians(45)
    ahead = np.array([np.cos(turned), np.sin(turned)])
    aside = np.array([-ahead[1], ahead[0]])
    last = drive.places[0] + INCH_M * (log[-1, 1] * ahead + log[-1, 2] * aside)
    assert drive.places[-1] == pytest.approx(last, abs=0.1)
    (count, driven_in) = drive.numbers(r"(\d+) records, [^$]*driven (\S+) in at")
    assert count == 400
    assert driven_in * INCH_M == pytest.approx(drive.robot.distance_m, rel=0.05)


def comes_home(drive: Drive) -> None:
    touches_nothing(drive)
    assert np.hypot(*(drive.places[-1] - drive.places[0])) < 8 * INCH_M
    assert "28 commands done\n" in drive.text


def tags_all_heat(drive: Drive) -> None:
    """The fires have 1, 2, 1 and 3 of heat; each robot says what it tagged, nobody twice."""
    touches_nothing(drive)
    found = re.findall(r"^leg (\d+): heat (\d+) at .*, 0 after tagging$", drive.text, re.MULTILINE)
    tagged = [int(heat) for heat in re.findall(r"(\d+) of heat tagged", drive.text)]
    assert len(tagged) == 3
    assert sum(tagged) == sum(int(heat) for _, heat in found) == 1 + 2 + 1 + 3


def pushes_what_is_in_the_way(drive: Drive) -> None:
    """One pushes a trolley into a carton, the other a drum; both come as far as they want."""
    lines = drive.text.splitlines()
    assert sum(line.startswith("pushing after 150 in") for line in lines) == 2
    assert [robot.collisions for robot in drive.robots] == [1, 1]
    trolley_m, drum_m = 2.22 - 0.2, 4.75 - 0.2
    pushed_m = drive.paths[:, :, 0].max(axis=0) - (trolley_m, drum_m)
    assert pushed_m[0] > 2.0
    assert 0.0 < pushed_m[1] < 0.5


def keeps_behind(drive: Drive) -> None:
    touches_nothing(drive)
    leader, follower = drive.robots
    assert leader.distance_m > 6
    assert follower.distance_m > 5
    apart_in = np.hypot(*(drive.paths[:, 0] - drive.paths[:, 1]).T) / INCH_M - 2 * 8
    assert apart_in.min() > 10
    assert apart_in.max() < 50


def goes_as_commanded(drive: Drive) -> None:
    """What the server publishes, in metres and radians, is what is so; it ends by a signal."""
    touches_nothing(drive)
    rows = re.findall(r"^ *\d+\.\d\d +(-?\d+\.\d+) +(-?\S+) +(-?\S+) +", drive.text, re.MULTILINE)
    x_m, y_m, heading_rad = map(float, rows[-1])
    assert drive.places[-1] - drive.places[0] == pytest.approx([x_m, y_m], abs=0.03)
    assert heading_rad == pytest.approx(-np.pi / 6, abs=0.15)
    assert drive.text.count("no command for 1 s: stopped\n") == 2
    (signal, way_m, turned_rad) = drive.numbers(
        r"signal (\d+): driven (\S+) m, turned by (\S+) rad"
    )
    assert signal == 14
    assert way_m == pytest.approx(drive.robot.distance_m, abs=0.05)
    assert turned_rad == pytest.approx(heading_rad, abs=0.1)


def keeps_its_eye_on_the_pillar(drive: Drive) -> None:
    """The course is 140 by 100 in, and ends where it began."""
    touches_nothing(drive)
    assert np.ptp(drive.places, axis=0) / INCH_M == pytest.approx([140, 100], abs=6)
    assert np.hypot(*(drive.places[-1] - drive.places[0])) < 5 * INCH_M
    reading_off_in, turret_off_deg = drive.numbers(
        r"sonar was (\S+) in off in the mean, the turret at most (\S+) degrees"
    )
    assert reading_off_in < 2
    assert turret_off_deg < 8


def climbs_the_ramp(drive: Drive) -> None:
    """The ramp begins 2 m from the wall and is 0.6 m high; limp, a robot rolls down half a metre.

    That is (g sin a - r cos a) / 2 with tan a = 0.15 and r = 0.3 m/s2.
    """
    touches_nothing(drive)
    assert drive.numbers(r"a ramp of (\d+) degrees begins after (\d+) in") == [
        pytest.approx(8.5, abs=0.6), pytest.approx(1.0 / INCH_M, abs=1)
    ]  # fmt: skip
    rolled_in, held_in = drive.numbers(r"it rolls (\S+) in, held it moves (\S+) in")
    expected_m = (9.80665 * 0.15 - 0.3) / math.hypot(1, 0.15) / 2
    assert rolled_in * INCH_M == pytest.approx(-expected_m, rel=0.1)  # the line takes time, too
    assert held_in == pytest.approx(0.0, abs=0.1)
    _, height_in = drive.numbers(r"after (\d+) in, (\d+) in above")
    assert height_in * INCH_M == pytest.approx(0.6, abs=0.03)
    assert 6.0 < drive.places[-1][0] < 9.0


def stops_at_both_edges(drive: Drive) -> None:
    """From below the edge at x = 4 m is heard; the one at x = 8 m is not, and nobody falls."""
    touches_nothing(drive)
    assert drive.numbers(r"from the floor: (\d+) in") == [pytest.approx(2.797 / INCH_M, abs=1)]
    assert drive.numbers(r"on the stage: (\d+) in") == [pytest.approx(5.8 / INCH_M, abs=3)]
    assert 7.4 < drive.places[-1][0] < 8.0


def serves_at_10_hz(drive: Drive) -> None:
    touches_nothing(drive)
    rows = re.findall(r"^ *(\S+) position +(\S+) +(\S+) .* (\S+) V$", drive.text, re.MULTILINE)
    table = np.array(rows, dtype=float)
    assert np.diff(table[:, 0]) == pytest.approx(2.0, abs=0.1)
    way_m = np.hypot(*np.diff(table[:, 1:3], axis=0).T).sum()
    assert 3 < way_m < drive.robot.distance_m + 0.1
    assert ((table[:, 3] > 10.8) & (table[:, 3] < 14)).all()
    assert drive.numbers(r"signal (\d+) after (\d+) updates, (\d+) failed") == [15, 401, 0]


def reckons_until_it_slips(drive: Drive) -> None:
    """Both opinions are good until the wheels slip at the wall; what is told as truth is true."""
    assert drive.robot.collisions >= 1
    rows = {}
    for line in drive.text.splitlines()[1:]:
        name, numbers = line[:13].strip(), re.findall(r"-?\d+\.\d", line[13:])
        rows[name] = np.array(numbers, dtype=float).reshape(-1)
    by_speeds, by_encoders = 3, 8  # columns: x, y, heading, error in, error deg; twice; the truth
    for name in ("start", "left square", "right square", "at the wall"):
        assert rows[name][by_speeds] < 3
        assert rows[name][by_encoders] < 3
    assert rows["away again"][by_speeds] > 4
    assert rows["away again"][by_encoders] > 4
    turned = np.radians(30)
    ahead, aside = np.array([np.cos(turned), np.sin(turned)]), [-np.sin(turned), np.cos(turned)]
    moved_in = (drive.places[-1] - drive.places[0]) / INCH_M
    assert rows["away again"][10:12] == pytest.approx([moved_in @ ahead, moved_in @ aside], abs=0.5)


def tells_ages_of_readings(drive: Drive) -> None:
    """Rate 15 fires each 60 ms; from one block to the next the robot drives 20 in.

    It comes at the wall by 30 degrees; the side of the beam, of 10 degrees, is what hears it first.
    """
    touches_nothing(drive)
    oldest_ms = [int(age) for age in re.findall(r"oldest (\d+) ms", drive.text)]
    assert [oldest_ms[0], oldest_ms[2]] == pytest.approx([15 * 60, 4 * 60], abs=90)
    assert oldest_ms[0] > oldest_ms[1] > oldest_ms[2] > oldest_ms[3]
    first = drive.text.split("oldest")[0]
    ages_ms = np.array(re.findall(r"#\d+ +(\d+) ms", first), dtype=float)
    steps_ms = np.diff(ages_ms)
    assert len(ages_ms) == 16
    assert steps_ms[steps_ms < 0] == pytest.approx(-60, abs=20)
    assert (steps_ms > 0).sum() <= 1
    ahead_in = np.array(re.findall(r"now (\S+) in", drive.text), dtype=float)
    nearer_in = 20.3 * np.cos(np.radians(30)) / np.cos(np.radians(20))
    assert -np.diff(ahead_in) == pytest.approx(nearer_in, abs=1.5)


def finds_out_which_sonar_lies(drive: Drive) -> None:
    """The sonar ahead is stuck from 12 s to 42 s, on the first two of the four legs."""
    touches_nothing(drive)
    pattern = r"^ *(\S+) s  sonar (\d+) (says|fits)"
    told = [
        (float(at_s), sonar, word)
        for at_s, sonar, word in re.findall(pattern, drive.text, re.MULTILINE)
    ]
    assert [(sonar, word) for _, sonar, word in told] == [("0", "says"), ("0", "fits")]
    assert 12 < told[0][0] < 16
    assert 42 < told[1][0] < 50
    ends = [int(end) for end in re.findall(r"leg \d ends (\d+) in before a wall", drive.text)]
    assert len(ends) == 4
    assert all(15 < end <= 30 for end in ends)
    x_in = drive.places[:, 0] / INCH_M
    assert x_in.max() == pytest.approx(10 / INCH_M - 30, abs=12)
    assert x_in.min() == pytest.approx(30, abs=12)


def carries_every_reading(drive: Drive) -> None:
    """Nothing goes through the wall, and the carrier goes to and fro for it."""
    touches_nothing(drive)
    numbers = [int(number) for number in re.findall(r"^reading (\d+)", drive.text, re.MULTILINE)]
    assert sorted(numbers) == list(range(10))
    assert drive.numbers(r"10 readings, (\d+) of them straight from the source") == [0]
    trips = re.findall(r"trip \d+: took over (\d+) readings, 0 are left", drive.text)
    assert len(trips) > 1
    assert sum(map(int, trips)) == 10
    crossings = np.count_nonzero(np.diff(drive.paths[:, 1, 0] > 5))
    assert crossings == 2 * len(trips) - 1


def keeps_together_by_radio(drive: Drive) -> None:
    """Four robots, 80 cm from each other; only the first one knows the way."""
    touches_nothing(drive)
    gaps_m = np.hypot(*np.diff(drive.paths, axis=1).transpose(2, 0, 1))
    assert gaps_m.min() > 0.45
    assert gaps_m.max() < 1.2
    told = drive.numbers(r"the leader told its place (\d+) times")[0]
    heard = [int(times) for times in re.findall(r"heard of the leader (\d+) times", drive.text)]
    assert np.array(heard) / told == pytest.approx(0.7, abs=0.1)
    distances_m = [robot.distance_m for robot in drive.robots]
    assert distances_m == pytest.approx([distances_m[0]] * 4, rel=0.05)


def stops_before_the_red_thing(drive: Drive) -> None:
    """The camera sits 6 in ahead of the middle, and stops 10 to 15 in before the column's side."""
    touches_nothing(drive)
    x_m, y_m = drive.places[-1]
    away_in = (math.hypot(x_m - 6.5, y_m - 5.2) - 0.15) / INCH_M
    assert 16 < away_in < 21.5


def passes_all_waypoints(drive: Drive) -> None:
    """Each within the 4 in of the program, 2 in that a fix is old, and four deviations of 1 cm."""
    touches_nothing(drive)
    for x_in, y_in in ((90, 40), (260, 130), (230, 190)):
        off_m = np.hypot(*(drive.places - np.array([x_in, y_in]) * INCH_M).T)
        assert off_m.min() < (4 + 2) * INCH_M + 0.04


def finds_the_stove(drive: Drive) -> None:
    """It reads 1000 at the stove's shell and 0 at 9 m from it: 900 within 0.9 m."""
    x_m, y_m = drive.places[-1]
    assert math.hypot(x_m - 8.6, y_m - 5.8) < 0.3 + 0.9 + 0.01
    began, ended = drive.numbers(r"it begins at (\d+)\n(\d+) after")
    first_m = math.hypot(8.6 - 1.0, 5.8 - 2.0) - 0.3
    assert began == pytest.approx(1000 * (1 - first_m / 9), abs=1)
    assert ended >= 900


def looks_far_and_near(drive: Drive) -> None:
    """The green column: 4.15 m from the sonar, told as 4.1 m; then in mm, with noise of 1 mm."""
    touches_nothing(drive)
    coarse, fine = drive.numbers(r"LF (\S+), HF (\S+)")
    assert (coarse, fine) == (round(4.1 / INCH_M * 10), -1)
    least, most = drive.numbers(r"there: HF (\d+) to (\d+)")
    x_m, y_m = drive.places[-1]
    true_in = (math.hypot(5.5 - x_m - 8 * INCH_M, 1.9 - y_m) - 0.15) / INCH_M
    assert least / 10 - 0.1 < true_in < most / 10 + 0.1
    assert most - least < 4


def drives_through_the_door(drive: Drive) -> None:
    """The partition stands at x = 8 m, and its door reaches from y = 1.5 m to 2.5 m."""
    touches_nothing(drive)
    (width,) = drive.numbers(r"a door of (\d+) in")
    assert width == pytest.approx(0.9 / INCH_M, abs=4)  # the walls have round ends of 5 cm
    x_m, y_m = drive.places[-1]
    assert x_m > 8.05 + 8 * INCH_M
    assert 1.5 < y_m < 2.5


def slides_along_the_wall(drive: Drive) -> None:
    """It keeps 7 in of a white wall, and half of a black one; walls are 10 cm thick."""
    touches_nothing(drive)
    for x_m, wall_y_m, gap_in in ((2.6, 2.5, 7.0), (7.0, 2.4, 3.5)):
        y_m = np.interp(x_m, *drive.places.T)
        assert (wall_y_m - 0.05 - y_m - 0.225) / INCH_M == pytest.approx(gap_in, abs=0.6)


def drives_its_square_by_compass(drive: Drive) -> None:
    """Sides of 60 in, turned by 30 degrees; the encoders believe to be far away."""
    touches_nothing(drive)
    turned = np.array([[math.cos(0.5236), -math.sin(0.5236)], [math.sin(0.5236), math.cos(0.5236)]])
    places_in = (drive.places - drive.places[0]) @ turned / INCH_M
    assert np.ptp(places_in, axis=0) == pytest.approx([60, 60], abs=4)
    assert np.hypot(*places_in[-1]) < 3
    closes_in, believed_in = drive.numbers(r"within (\S+) in by compass; encoders say (\S+) in")
    assert closes_in < 3
    assert believed_in > 20


def sorts_cans(drive: Drive) -> None:
    """Heavy cans stand to the left of the robot's home, light ones to the right."""
    assert drive.robot.exit_status == 0
    for name, (x_m, y_m, _) in drive.objects.items():
        assert x_m == pytest.approx(-70 * INCH_M, abs=0.1)
        assert (y_m > 1.0) if name.startswith("heavy") else (y_m < -1.0)


def follows_trail(drive: Drive) -> None:
    """Both followers come to the end of the scout's winding trail, and none touches another."""
    touches_nothing(drive)
    assert [robot.exit_status for robot in drive.robots] == [0, 0, 0]
    assert [goal.status for goal in drive.goals] == ["met"]


def spreads_out(drive: Drive) -> None:
    """The crowd gets at least 1.3 times as wide as the distribution that it was drawn from."""
    touches_nothing(drive)
    places_m = np.array([robot.pose[:2] for robot in drive.robots])
    assert len(places_m) == 12
    assert (places_m.std(axis=0) > 1.3).any()


def puts_cans_into_a_row(drive: Drive) -> None:
    touches_nothing(drive)
    places_in = {
        name: (x_m / INCH_M, y_m / INCH_M) for name, (x_m, y_m, _) in drive.objects.items()
    }
    for name, x_in in (("red", 0), ("green", 4), ("blue", -4)):
        assert places_in[name] == pytest.approx((x_in, 22), abs=0.1)


def comes_to_the_light(drive: Drive) -> None:
    """The lamp of 400 reads 600 from 82 cm."""
    touches_nothing(drive)
    assert drive.text.splitlines()[-1].startswith("light at")
    assert np.hypot(*(drive.places[-1] - [100 * INCH_M, 60 * INCH_M])) < 0.85


def follows_the_lamp(drive: Drive) -> None:
    """The lamp of 400 reads 300 from 1.15 m; the guide goes 120 in ahead and 100 in to the left."""
    touches_nothing(drive)
    assert [robot.exit_status for robot in drive.robots] == [0, 0]
    guide, follower = drive.paths[-1]
    assert guide == pytest.approx([180 * INCH_M, 140 * INCH_M], abs=0.02)
    assert 0.9 < np.hypot(*(follower - guide)) < 1.4
    assert follower[1] > drive.paths[0, 1, 1] + 0.9


def finds_who_calls(drive: Drive) -> None:
    """The call of 500 is 450 from 1.1 m; the wall between has its end at y = -40 in."""
    assert [robot.exit_status for robot in drive.robots] == [0, 0]
    caller, seeker = drive.paths[0, 0], drive.paths[:, 1]
    assert np.hypot(*(seeker[-1] - caller)) < 1.2
    assert seeker[:, 1].min() < -40 * INCH_M


def pushes_the_crate_together(drive: Drive) -> None:
    """The floor holds the crate with 70 N, and a Scout has 60 N."""
    x_m, y_m, heading_rad = drive.objects["crate"]
    assert x_m == pytest.approx((-60 + 80) * INCH_M, abs=0.05)
    assert abs(y_m) < 0.05
    assert abs(heading_rad) < math.radians(3)
