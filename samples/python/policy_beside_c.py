"""A Python policy leads a robot whose C program follows by sonar.

The leader drives from point to point; it is steered here, ten times a second. The follower runs the
C program below, which keeps its distance with its front sonars.

    python policy_beside_c.py
"""

import math

import crs_cc

WORLD = """<world version="1" duration="60s">
  <area length="8m" width="6m"/>
  <robot id="leader" x="2.2m" y="1m"/>
  <robot id="follower" x="1.2m" y="1m"/>
</world>"""
FOLLOWER = """
#include <Nclient.h>

int main(void)
{
    connect_robot(1);
    for (;;) {
        int left, right, ahead, speed, turn;

        get_sn();
        left = State[18] < State[19] ? State[18] : State[19];     /* sonars 1 and 2 */
        right = State[32] < State[31] ? State[32] : State[31];    /* sonars 15 and 14 */
        ahead = State[17] < left ? State[17] : left;
        ahead = ahead < right ? ahead : right;
        speed = ahead > 60 ? 0 : (ahead - 16) * 12;               /* 16 inches behind */
        turn = left < right - 3 ? 40 : right < left - 3 ? -40 : 0;
        vm(speed + turn, speed - turn, 0);
    }
}
"""
POINTS = [(5.5, 1.0), (6.8, 2.5), (6.0, 4.5), (3.0, 5.0)]
WHEEL_BASE_M = 0.345


def policy(pose: tuple[float, float, float], point: tuple[float, float]) -> tuple[float, float]:
    """Return the speeds of the right and the left wheel [m/s] toward a point."""
    x_m, y_m, heading_rad = pose
    bearing_rad = math.atan2(point[1] - y_m, point[0] - x_m) - heading_rad
    bearing_rad = math.remainder(bearing_rad, math.tau)
    forward_mps = 0.2 * max(0.2, math.cos(bearing_rad))
    turn_mps = max(-0.6, min(0.6, bearing_rad)) * WHEEL_BASE_M / 2
    return forward_mps + turn_mps, forward_mps - turn_mps


def main() -> None:
    env = crs_cc.Env(WORLD, {"follower": FOLLOWER}, observe=["pose"], step_s=0.1)
    points = list(POINTS)
    seen = env.reset()
    env.session.on("collision", lambda event: print(f"{event.time_s:.1f} s: {event.text}"))
    while points and not env.is_time_up:
        pose = tuple(seen["leader"]["pose"].tolist())
        if math.dist(pose[:2], points[0]) < 0.2:
            apart_m = math.dist(pose[:2], env.session.robots["follower"].position_m)
            print(f"{env.time_s:4.1f} s: at {points.pop(0)}, the follower {apart_m:.2f} m behind")
        if points:
            seen = env.step({"leader": policy(pose, points[0])})
    print("finished" if not points else "too late")


if __name__ == "__main__":
    main()
