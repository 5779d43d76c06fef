/* Dead reckoning of a two-wheeled robot: ticks, arcs, errors that grow, angles that wrap. */
#include <math.h>
#include <stdio.h>

#define WHEEL_BASE_M 0.345
#define TICKS_PER_M 12000L
#define PI 3.14159265358979323846

typedef struct pose { double x, y, theta; } Pose;
typedef struct { short left, right; } Ticks;

static double wrapped(double angle)
{
    while (angle > PI)
        angle -= 2 * PI;
    while (angle <= -PI)
        angle += 2 * PI;
    return angle;
}

/* Counters are 16 bits wide and run over. */
static Ticks between(Ticks before, Ticks now)
{
    Ticks t;
    t.left = (short) (now.left - before.left);
    t.right = (short) (now.right - before.right);
    return t;
}

static Pose advanced(Pose p, Ticks t)
{
    double left = (double) t.left / TICKS_PER_M, right = (double) t.right / TICKS_PER_M;
    double way = (left + right) / 2, turn = (right - left) / WHEEL_BASE_M;

    if (fabs(turn) < 1e-9) {
        p.x += way * cos(p.theta);
        p.y += way * sin(p.theta);
    } else {
        double radius = way / turn;
        p.x += radius * (sin(p.theta + turn) - sin(p.theta));
        p.y -= radius * (cos(p.theta + turn) - cos(p.theta));
    }
    p.theta = wrapped(p.theta + turn);
    return p;
}

int main(void)
{
    Pose pose = { 0, 0, PI / 2 };
    Ticks counters = { 32000, -32768 }, before = counters;
    static const struct { int left, right, turns; } plan[] = {
        { 600, 600, 20 }, { -260, 260, 13 }, { 500, 620, 25 }, { 0, 0, 3 }, { -400, -380, 30 },
    };

    for (unsigned i = 0; i < sizeof plan / sizeof plan[0]; i++) {
        for (int turn = 0; turn < plan[i].turns; turn++) {
            counters.left += plan[i].left;
            counters.right += plan[i].right;
            pose = advanced(pose, between(before, counters));
            before = counters;
        }
        printf("%+.3f %+.3f %+7.2f deg  %6d %6d\n", pose.x, pose.y, pose.theta * 180 / PI,
               counters.left, counters.right);
    }
    printf("%.4f\n", hypot(pose.x, pose.y));
    return 0;
}
