/* Gravity between five bodies: floating arithmetic on structs, sqrt. */
#include <math.h>
#include <stdio.h>

#define BODIES 5

struct body {
    double x, y, z, vx, vy, vz, mass;
};

/* Made-up planets around a heavy one, in units of our own. */
static struct body bodies[BODIES] = {
    { 0, 0, 0, 0, 0, 0, 40 },
    { 5, -1, 0.1, 0.5, 2.7, 0, 0.04 },
    { 8, 4, -0.4, -1.0, 1.8, 0.1, 0.01 },
    { 13, -15, -0.2, 1.1, 0.9, 0, 0.002 },
    { 15, -26, 0.2, 1.0, 0.6, -0.1, 0.002 },
};

static void advance(double dt)
{
    int i, j;

    for (i = 0; i < BODIES; i++) {
        struct body *b = &bodies[i];
        for (j = i + 1; j < BODIES; j++) {
            struct body *c = &bodies[j];
            double dx = b->x - c->x, dy = b->y - c->y, dz = b->z - c->z;
            double square = dx * dx + dy * dy + dz * dz;
            double pull = dt / (square * sqrt(square));
            b->vx -= dx * c->mass * pull;
            b->vy -= dy * c->mass * pull;
            b->vz -= dz * c->mass * pull;
            c->vx += dx * b->mass * pull;
            c->vy += dy * b->mass * pull;
            c->vz += dz * b->mass * pull;
        }
    }
    for (i = 0; i < BODIES; i++) {
        bodies[i].x += dt * bodies[i].vx;
        bodies[i].y += dt * bodies[i].vy;
        bodies[i].z += dt * bodies[i].vz;
    }
}

static double energy(void)
{
    double e = 0;
    int i, j;

    for (i = 0; i < BODIES; i++) {
        struct body *b = &bodies[i];
        e += b->mass * (b->vx * b->vx + b->vy * b->vy + b->vz * b->vz) / 2;
        for (j = i + 1; j < BODIES; j++) {
            double dx = b->x - bodies[j].x, dy = b->y - bodies[j].y, dz = b->z - bodies[j].z;
            e -= b->mass * bodies[j].mass / sqrt(dx * dx + dy * dy + dz * dz);
        }
    }
    return e;
}

int main(void)
{
    int i;

    for (i = 0; i < 250000; i++)
        advance(0.001);
    printf("nbody %.6f\n", energy());
    return 0;
}
