/* Sonars in calm time, see calm.c: what firings depend on is in its tables. */
#include "calm.h"
#include "robot.h"

const double *__crs_drawn(const struct calm *calm, const struct drawn *drawn, long long sensor,
                          long long number, int width)
{
    const double *numbers = (const double *)calm;

    number -= ((const long long *)(numbers + drawn->first))[sensor];
    if (number < 0 || number >= drawn->draws)
        return 0;
    return numbers + drawn->deviates + (sensor * drawn->draws + number) * width;
}

/* Set what the firing of sonars depends on; return whether it is all known. */
static int look_around(const struct calm *calm, int count, const long long *some, const double *to,
                       const struct tables *tables, struct surroundings *around)
{
    static double modes[MOST], deviates[MOST * DEVIATES];
    const double *mode = TABLE(calm, const double, modes), *known;
    const double *mistakes = TABLE(calm, const double, mistakes);
    int i, k;

    for (i = 0; i < count; i++) {
        long long row = some[i];

        modes[i] = mode[row];
        if (tables->robots[row].fires > to[i] || calm->sonar.draws == 0)
            continue;
        known = __crs_drawn(calm, &calm->sonar, row, tables->sonars[row].count, DEVIATES);
        if (!known)
            return DRAWN;
        for (k = 0; k < DEVIATES; k++)
            deviates[DEVIATES * i + k] = known[k];
        if (known[2] < mistakes[(int)mode[row] + tables->sonars[row].mode])
            return REFUSED;
    }
    around->modes = modes;
    around->deviates = deviates;
    around->beams = TABLE(calm, const double, beams);
    around->segments = TABLE(calm, const double, segments);
    around->circles = TABLE(calm, const double, circles);
    around->segment_count = (int)calm->segment_count;
    around->circle_count = (int)calm->circle_count;
    around->work = TABLE(calm, double, work);
    return RUN;
}

int __crs_calm_fire(struct calm *calm, int count, const long long *rows, const double *to,
                    const struct tables *tables)
{
    struct surroundings around;
    int i, found;

    for (i = 0; i < count; i++)
        if (tables->robots[rows[i]].timer <= to[i])
            return REFUSED;
    do {
        found = look_around(calm, count, rows, to, tables, &around);
        if (found != RUN)
            return found;
        found = __crs_fire(count, rows, to, &around, tables);
    } while (found == SENSOR_DUE);
    return found == ADVANCED ? RUN : REFUSED;
}
