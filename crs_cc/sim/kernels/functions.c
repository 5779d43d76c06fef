/* Elementwise functions of arrays, by their numbers in `exact.py` and `program.py`. A complex number is two doubles,
   as in numpy. */
#include <math.h>

#include "kernels.h"

#define EACH(expression)                \
    for (i = 0; i < count; i++)         \
        out[i] = expression;            \
    break

static void turns(int count, const double *angle, double *out)
{
    int i;

    for (i = 0; i < count; i++)
        __crs_sin_cos(angle[i], &out[2 * i + 1], &out[2 * i]);
}

static void products(int count, const double *a, const double *b, double *out)
{
    int i;

    for (i = 0; i < 2 * count; i += 2) {
        double ar = a[i], ai = a[i + 1], br = b[i], bi = b[i + 1];

        out[i] = ar * br - ai * bi;
        out[i + 1] = ar * bi + ai * br;
    }
}

void __crs_arc(double heading, double way, double turn, double *x, double *y)
{
    double half = turn == 0 ? 1e-20 : turn / 2;         /* sin(x) / x is 1 at 0 */
    double direction = heading + turn / 2, chord = way * (sin(half) / half);

    *x = chord * cos(direction);
    *y = chord * sin(direction);
}

/* Arcs: x replaces the headings, y the lengths. */
static void arcs(int count, double *heading, double *way, const double *turn)
{
    int i;

    for (i = 0; i < count; i++)
        __crs_arc(heading[i], way[i], turn[i], &heading[i], &way[i]);
}

static void normal_pairs(int count, const double *a, const double *b, double *out)
{
    int i;

    for (i = 0; i < count; i++) {
        double away = __builtin_sqrt(-2 * log(1 - a[i]));       /* 1 - a is never 0 */
        double angle = 2 * M_PI * b[i];

        out[2 * i] = away * cos(angle);
        out[2 * i + 1] = away * sin(angle);
    }
}

void __crs_apply(int function, int count, double *a, double *b, double *out)
{
    int i;

    switch (function) {
    case 0: EACH(sin(a[i]));
    case 1: EACH(cos(a[i]));
    case 2: EACH(tan(a[i]));
    case 3: EACH(asin(a[i]));
    case 4: EACH(acos(a[i]));
    case 5: EACH(atan(a[i]));
    case 6: EACH(atan2(a[i], b[i]));
    case 7: EACH(exp(a[i]));
    case 8: EACH(exp2(a[i]));
    case 9: EACH(log(a[i]));
    case 10: EACH(pow(a[i], b[i]));
    case 11: turns(count, a, out); break;
    case 12: products(count, a, b, out); break;
    case 13: arcs(count, a, b, out); break;
    case 14: normal_pairs(count, a, b, out); break;
    case 15: EACH(__crs_board_ms(a[i], b[i]));
    }
}
