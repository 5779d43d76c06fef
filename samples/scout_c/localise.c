/*
 * localise.c - find out where in a known room the robot is: Monte Carlo localisation.
 *
 * The map says where walls are, nothing says where the robot was put. A cloud of
 * particles, each a pose that may be the true one, is thrown over the whole floor
 * (Dellaert, Fox, Burgard and Thrun 1999). Then, over and over:
 *
 *     move      the robot drives a little way to where there is room; each
 *               particle moves as the encoders say, with an error of chance
 *     look      all sonars fire; the end of each beam, seen from a particle, should
 *               lie on a wall. How far it lies from one is looked up in a field
 *               computed beforehand, and weighs the particle
 *     resample  particles are drawn anew by their weights; a few are thrown
 *               anywhere, in case that all are wrong
 *
 * The estimate is the middle of the particles around the best one. To judge it the
 * simulator is asked for the truth, get_rpx(), and for comparison the last column
 * has the error of encoders that were told the truth at the start: where wheels
 * slip (crs run --setup noisy) theirs grows, and that of the estimate does not.
 *
 * Usage:  crs run localise.c studio.xml --file worlds/studio.map
 *         ... -- MAP                    another map
 */

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "Nclient.h"

#define ROBOT_ID    1
#define N_SONARS    16
#define SHELL       8.0      /* radius of the robot, inches */
#define PARTICLES   1500
#define LOST        75       /* number of random particles added each time */
#define STEPS       16
#define LONGEST     20.0     /* of a move, inches */
#define FAR         150.0    /* ignore echoes beyond this, inches */
#define SIGMA       4.0      /* error of a beam's end, inches */
#define CELL        2.0      /* of the field, inches */
#define MARGIN      20.0     /* around the room, inches */
#define MAX_WALLS   200
#define MAX_ROBOTS  20
#define RADIANS(d)  ((d) * M_PI / 180.0)
#define DEGREES(r)  ((r) * 180.0 / M_PI)

typedef struct { double x, y; } Point;
typedef struct { Point from, to; } Wall;
typedef struct { double x, y, heading; } Pose;
typedef struct { Pose pose; double weight; } Particle;

static Wall walls[MAX_WALLS];
static int n_walls;
static Point corner = { 1e9, 1e9 }, across = { -1e9, -1e9 };   /* of the room */

static float *field;                 /* distance to the next wall, inches */
static int columns, rows;

static Particle cloud[PARTICLES], drawn[PARTICLES];
static int order[N_SONARS] = { 0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8 };

/* ---- random numbers ---- */

static double uniform(double low, double high)
{
    return low + (high - low) * rand() / (RAND_MAX + 1.0);
}

/* Returns a normal deviate, approximated by the sum of twelve uniform ones. */
static double normal(double sigma)
{
    double sum = -6.0;
    int i;

    for (i = 0; i < 12; i++)
        sum += uniform(0.0, 1.0);
    return sigma * sum;
}

/* ---- the map: lines of "name corners x y x y ..." ---- */

static void fail(const char *what, const char *name)
{
    fprintf(stderr, "localise: %s: %s\n", name, what);
    exit(1);
}

static double number(const char *file)
{
    char *word = strtok(NULL, " \t\n"), *end;
    double value = word == NULL ? 0.0 : strtod(word, &end);

    if (word == NULL || *end != '\0')
        fail("a number is missing", file);
    return value;
}

static void add_wall(Point from, Point to)
{
    if (n_walls == MAX_WALLS)
        fail("too many walls", "map");
    walls[n_walls].from = from;
    walls[n_walls++].to = to;
    corner.x = fmin(corner.x, from.x);
    corner.y = fmin(corner.y, from.y);
    across.x = fmax(across.x, from.x);
    across.y = fmax(across.y, from.y);
}

static void read_map(const char *name)
{
    FILE *file = fopen(name, "r");
    char line[256], *word;
    Point first, last, next;
    int corners, i;

    if (file == NULL)
        fail(strerror(errno), name);
    while (fgets(line, sizeof line, file) != NULL) {
        word = strtok(line, " \t\n");
        if (word == NULL || *word == '#')
            continue;
        corners = (int) number(name);
        if (corners < 3)
            fail("a polygon has three corners at least", name);
        first.x = number(name);
        first.y = number(name);
        last = first;
        for (i = 1; i < corners; i++) {
            next.x = number(name);
            next.y = number(name);
            add_wall(last, next);
            last = next;
        }
        add_wall(last, first);
    }
    fclose(file);
}

static double wall_distance(const Wall *wall, Point p)
{
    double wx = wall->to.x - wall->from.x, wy = wall->to.y - wall->from.y;
    double px = p.x - wall->from.x, py = p.y - wall->from.y;
    double along = (px * wx + py * wy) / (wx * wx + wy * wy);

    along = fmin(fmax(along, 0.0), 1.0);
    return hypot(px - along * wx, py - along * wy);
}

/* A point is on the floor if there is an odd number of walls to its right. */
static int on_floor(Point p)
{
    const Wall *w;
    int inside = 0;

    for (w = walls; w < walls + n_walls; w++)
        if ((w->from.y > p.y) != (w->to.y > p.y)
            && p.x < w->from.x + (w->to.x - w->from.x) * (p.y - w->from.y)
                                 / (w->to.y - w->from.y))
            inside = !inside;
    return inside;
}

static void make_field(void)
{
    Point p;
    int row, column, i;
    double nearest;

    columns = (int) ((across.x - corner.x + 2.0 * MARGIN) / CELL) + 1;
    rows = (int) ((across.y - corner.y + 2.0 * MARGIN) / CELL) + 1;
    field = malloc((size_t) columns * rows * sizeof *field);
    if (field == NULL)
        fail("no memory", "field");
    for (row = 0; row < rows; row++)
        for (column = 0; column < columns; column++) {
            p.x = corner.x - MARGIN + (column + 0.5) * CELL;
            p.y = corner.y - MARGIN + (row + 0.5) * CELL;
            nearest = 1e9;
            for (i = 0; i < n_walls; i++)
                nearest = fmin(nearest, wall_distance(&walls[i], p));
            field[row * columns + column] = (float) nearest;
        }
}

/* Returns the distance from a point to the nearest wall; MARGIN outside the field. */
static double field_at(double x, double y)
{
    int column = (int) floor((x - corner.x + MARGIN) / CELL);
    int row = (int) floor((y - corner.y + MARGIN) / CELL);

    if (column < 0 || column >= columns || row < 0 || row >= rows)
        return MARGIN;
    return field[row * columns + column];
}

/* ---- the filter ---- */

/* Places a particle at random on the floor where the robot fits. */
static void throw_anywhere(Particle *particle)
{
    Point p;

    do {
        p.x = uniform(corner.x, across.x);
        p.y = uniform(corner.y, across.y);
    } while (field_at(p.x, p.y) < SHELL || !on_floor(p));
    particle->pose.x = p.x;
    particle->pose.y = p.y;
    particle->pose.heading = uniform(-M_PI, M_PI);
    particle->weight = 1.0;
}

/* Moves all particles by the encoders' motion, each with its own random error. */
static void move(double way, double turn)
{
    Particle *p;
    double far;

    for (p = cloud; p < cloud + PARTICLES; p++) {
        p->pose.heading += turn + normal(RADIANS(1.0) + 0.05 * fabs(turn));
        far = way + normal(0.5 + 0.05 * fabs(way));
        p->pose.x += far * cos(p->pose.heading);
        p->pose.y += far * sin(p->pose.heading);
    }
}

/* Returns how well the readings of the ring agree with a pose. */
static double agreement(const Pose *pose)
{
    double log_sum = 0.0, direction, far, off;
    Point place = { pose->x, pose->y };
    int i;

    if (field_at(pose->x, pose->y) < SHELL - CELL || !on_floor(place))
        return 0.0;
    for (i = 0; i < N_SONARS; i++) {
        far = State[STATE_SONAR_0 + i];
        if (far > FAR)
            continue;
        direction = pose->heading + i * 2.0 * M_PI / N_SONARS;
        far += SHELL;
        off = field_at(pose->x + far * cos(direction), pose->y + far * sin(direction)) / SIGMA;
        log_sum += log(0.95 * exp(-0.5 * off * off) + 0.05);
    }
    return exp(0.4 * log_sum);      /* neighbours see the same wall: weigh them less */
}

static void look(void)
{
    Particle *p;

    for (p = cloud; p < cloud + PARTICLES; p++)
        p->weight = agreement(&p->pose);
}

/* Resamples all particles by their weights, with one random number (Baker's wheel). */
static void resample(void)
{
    double total = 0.0, step, mark, sum;
    Particle *p, *from = cloud;
    int kept = PARTICLES - LOST;

    for (p = cloud; p < cloud + PARTICLES; p++)
        total += p->weight;
    if (total == 0.0) {
        for (p = cloud; p < cloud + PARTICLES; p++)
            throw_anywhere(p);
        return;
    }
    step = total / kept;
    mark = uniform(0.0, step);
    sum = from->weight;
    for (p = drawn; p < drawn + kept; p++, mark += step) {
        while (sum < mark && from < cloud + PARTICLES - 1)
            sum += (++from)->weight;
        *p = *from;
    }
    for (; p < drawn + PARTICLES; p++)
        throw_anywhere(p);
    memcpy(cloud, drawn, sizeof cloud);
}

static double apart(const Pose *a, const Pose *b)
{
    return hypot(a->x - b->x, a->y - b->y);
}

/* Returns the mean of the particles near the best one; *share gets their weight. */
static Pose estimate(double *share)
{
    const Particle *p, *best = cloud;
    double total = 0.0, near = 0.0, x = 0.0, y = 0.0, c = 0.0, s = 0.0;
    Pose middle;

    for (p = cloud; p < cloud + PARTICLES; p++)
        if (p->weight > best->weight)
            best = p;
    for (p = cloud; p < cloud + PARTICLES; p++) {
        total += p->weight;
        if (apart(&p->pose, &best->pose) > 15.0
            || cos(p->pose.heading - best->pose.heading) < 0.8)
            continue;
        near += p->weight;
        x += p->weight * p->pose.x;
        y += p->weight * p->pose.y;
        c += p->weight * cos(p->pose.heading);
        s += p->weight * sin(p->pose.heading);
    }
    if (near == 0.0) {          /* no particle agrees with anything */
        *share = 0.0;
        return best->pose;
    }
    *share = near / total;
    middle.x = x / near;
    middle.y = y / near;
    middle.heading = atan2(s, c);
    return middle;
}

/* ---- the robot ---- */

static Pose encoders(void)
{
    Pose pose;

    pose.x = State[STATE_CONF_X] / 10.0;
    pose.y = State[STATE_CONF_Y] / 10.0;
    pose.heading = RADIANS(State[STATE_CONF_STEER] / 10.0);
    return pose;
}

/* Reads the true pose; FALSE if it is not available. */
static int truth(Pose *pose)
{
    long robots[1 + 3 * MAX_ROBOTS];

    if (!get_rpx(robots) || robots[0] < 1)
        return FALSE;
    pose->x = robots[1] / 10.0;
    pose->y = robots[2] / 10.0;
    pose->heading = RADIANS(robots[3] / 10.0);
    return TRUE;
}

/* Returns the pose by encoders that started at the true pose. */
static Pose in_room(const Pose *start, const Pose *moved)
{
    Pose pose;

    pose.x = start->x + moved->x * cos(start->heading) - moved->y * sin(start->heading);
    pose.y = start->y + moved->x * sin(start->heading) + moved->y * cos(start->heading);
    pose.heading = start->heading + moved->heading;
    return pose;
}

static void print_pose(const Pose *pose)
{
    printf("   %6.1f %6.1f %6.1f", pose->x, pose->y,
           DEGREES(remainder(pose->heading, 2.0 * M_PI)));
}

/* Waits until each sonar has fired. */
static void listen(void)
{
    usleep(1100000);
    gs();
}

static double room(int sonar)
{
    int i;
    double nearest = FAR;

    for (i = sonar - 1; i <= sonar + 1; i++)
        nearest = fmin(nearest, State[STATE_SONAR_0 + (i & (N_SONARS - 1))]);
    return nearest;
}

/* Turns to a free direction, preferably forward, and drives a short distance. */
static void drive(void)
{
    int sonar, best = 0, turn;
    double worth, most = -1e9;

    for (sonar = -7; sonar <= 8; sonar++) {
        worth = fmin(room(sonar), 60.0) - 3.0 * abs(sonar) + uniform(0.0, 15.0);
        if (room(sonar) < 16.0)
            worth -= 100.0;
        if (worth > most) {
            most = worth;
            best = sonar;
        }
    }
    turn = best * 225;
    if (turn != 0) {
        scout_pr(0, turn);
        ws(1, 1, 0, 20);
    }
    scout_pr((int) (10.0 * fmin(LONGEST, fmax(room(best) - 12.0, 0.0))), 0);
    ws(1, 1, 0, 20);
}

int main(int argc, char **argv)
{
    const char *map = argc > 1 ? argv[1] : "worlds/studio.map";
    Pose start = { 0.0, 0.0, 0.0 }, before, after, guess, real, reckoned;
    double share;
    int step;

    read_map(map);
    make_field();
    srand(1999);
    for (step = 0; step < PARTICLES; step++)
        throw_anywhere(&cloud[step]);

    if (!connect_robot(ROBOT_ID, MODEL_SCOUT, "/dev/ttyS0", 38400)) {
        fprintf(stderr, "localise: no robot\n");
        return 1;
    }
    conf_tm(5);
    conf_sn(15, order);
    ac(200, 200, 0);
    sp(100, 100, 0);
    dp(0, 0);
    da(0, 0);
    truth(&start);
    printf("%d walls, %d particles\n", n_walls, PARTICLES);
    printf("step    estimate              sure     truth                  error"
           "                 of encoders\n");

    listen();
    before = encoders();
    for (step = 0; step < STEPS; step++) {
        if (step > 0) {
            drive();
            listen();
        }
        after = encoders();
        move(apart(&after, &before), remainder(after.heading - before.heading, 2.0 * M_PI));
        before = after;
        look();
        guess = estimate(&share);
        printf("%3d ", step);
        print_pose(&guess);
        printf("   %4.0f %%", 100.0 * share);
        if (truth(&real)) {
            reckoned = in_room(&start, &after);
            print_pose(&real);
            printf("   %5.1f in %6.1f deg   %5.1f in", apart(&guess, &real),
                   DEGREES(remainder(guess.heading - real.heading, 2.0 * M_PI)),
                   apart(&reckoned, &real));
        }
        printf("\n");
        resample();
    }
    st();
    free(field);
    disconnect_robot(ROBOT_ID);
    return 0;
}
