/* Bodies that attract each other; vectors are structs passed and returned by value. */
#include <math.h>
#include <stdio.h>

#define BODIES 6

struct vector { double x, y, z; };
struct body { struct vector at, speed; double mass; };

static struct vector add(struct vector a, struct vector b)
{
    struct vector sum = { a.x + b.x, a.y + b.y, a.z + b.z };
    return sum;
}

static struct vector subtract(struct vector a, struct vector b)
{
    struct vector difference = { a.x - b.x, a.y - b.y, a.z - b.z };
    return difference;
}

static struct vector scale(struct vector a, double by)
{
    struct vector scaled = { a.x * by, a.y * by, a.z * by };
    return scaled;
}

static double dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static void step(struct body *bodies, int count, double time)
{
    int i, j;

    for (i = 0; i < count; i++)
        for (j = i + 1; j < count; j++) {
            struct vector d = subtract(bodies[j].at, bodies[i].at);
            double square = dot(d, d) + 0.01;
            double pull = time / (square * sqrt(square));
            bodies[i].speed = add(bodies[i].speed, scale(d, pull * bodies[j].mass));
            bodies[j].speed = subtract(bodies[j].speed, scale(d, pull * bodies[i].mass));
        }
    for (i = 0; i < count; i++)
        bodies[i].at = add(bodies[i].at, scale(bodies[i].speed, time));
}

int main(void)
{
    struct body bodies[BODIES];
    double energy = 0;
    int i;

    for (i = 0; i < BODIES; i++) {
        struct vector at = { i * 1.5, (i * 7 % 5) - 2.0, (i * 3 % 4) * 0.5 };
        struct vector speed = { 0.1 * (i % 3), 0.05 * i, -0.02 * i };
        bodies[i].at = at;
        bodies[i].speed = speed;
        bodies[i].mass = 1.0 + i % 2;
    }
    for (i = 0; i < 300000; i++)
        step(bodies, BODIES, 0.0005);
    for (i = 0; i < BODIES; i++)
        energy += bodies[i].mass * dot(bodies[i].speed, bodies[i].speed);
    printf("nbody_structs %.6f\n", energy);
    return 0;
}
