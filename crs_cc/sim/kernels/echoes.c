/* The first echo of each of some pings, see `geometry/echoes.py`. Points are relative to the
   transducer, whose axis is x, once a shape is kept. */
#include <math.h>

#include "echoes.h"
#include "kernels.h"

#define ON_M 1e-9           /* a transducer this close to a face is on it */
#define BEFORE_M 1e-6       /* an object closer than this to a target does not hide it */
#define SEAM_M 1e-3         /* faces whose ends are this close touch */
#define STRAIGHT 1e-3       /* sine of the angle below which a face continues in another */
#define FEW 256
#define ANY_ANGLE (M_PI / 2)    /* the critical angle of diffuse faces */
#define SIDES 2                 /* rays along the sides of a beam */
#define LOBE_RAYS 17            /* and in between, if the reach falls off the axis */

static const struct ping *ping;
static struct face *faces;
static struct round *rounds;
static int face_count, round_count;
static double cosine, sine, tangent, found;

#define CROSS(a, b) ((a).x * (b).y - (a).y * (b).x)
#define DOT(a, b) ((a).x * (b).x + (a).y * (b).y)
#define LENGTH(a) __builtin_sqrt(DOT(a, a))
#define MINUS(result, a, b) ((result).x = (a).x - (b).x, (result).y = (a).y - (b).y)

/* The point of the world in the frame of the transducer. */
#define LOCAL(result, a)                                                        \
    do {                                                                        \
        double x_ = (a).x - ping->start.x, y_ = (a).y - ping->start.y;          \
        (result).x = x_ * ping->axis.x + y_ * ping->axis.y;                     \
        (result).y = y_ * ping->axis.x - x_ * ping->axis.y;                     \
    } while (0)

static double range_at(double angle)
{
    if (ping->falloff == 0)
        return ping->range;
    return ping->range * exp2(-ping->falloff * angle * angle);
}

static double to_face(const struct face *face, const struct point *ray)
{
    double across = CROSS(*ray, face->along);
    double distance = CROSS(face->start, face->along) / across;
    double share = CROSS(face->start, *ray) / across;

    return distance > 0 && share >= 0 && share <= 1 ? distance : INFINITY;
}

static double to_round(const struct round *round, const struct point *ray)
{
    double along = DOT(round->middle, *ray);
    double aside = round->middle.y * ray->x - round->middle.x * ray->y;
    double square = round->radius * round->radius - aside * aside;

    return square >= 0 && along > 0 ? along - __builtin_sqrt(square) : INFINITY;
}

/* Keep the faces that may be in the beam; return whether the transducer is on or in one. */
static int keep_faces(int count)
{
    struct point a, b, middle, from_a, from_b;
    int i, inside = 0;

    LOCAL(middle, ping->place);
    face_count = 0;
    for (i = 0; i < count; i++) {
        double length = faces[i].away, share = faces[i].share, behind;
        struct face *kept = &faces[face_count];

        LOCAL(a, faces[i].start);
        LOCAL(b, faces[i].along);
        behind = CROSS(a, b) / length;      /* depth of the transducer in the solid */
        if (behind >= -ON_M) {
            /* The robot's centre may be in the plane of a face: rounding must not move it in
               front. */
            MINUS(from_a, a, middle);
            MINUS(from_b, b, middle);
            if (CROSS(from_a, from_b) < -ON_M * length
                && CROSS(middle, a) * CROSS(middle, b) <= 0)
                inside = 1;
            continue;
        }
        if (-behind > ping->range)
            continue;
        if (cosine * a.y - sine * a.x > 0 && cosine * b.y - sine * b.x > 0)
            continue;
        if (-cosine * a.y - sine * a.x > 0 && -cosine * b.y - sine * b.x > 0)
            continue;
        kept->start.x = a.x;
        kept->start.y = a.y;
        MINUS(kept->along, b, a);
        kept->away = -behind;
        kept->share = share;
        face_count++;
    }
    return inside;
}

/* The same with circles. */
static int keep_rounds(int count)
{
    struct point middle;
    int i, inside = 0;

    round_count = 0;
    for (i = 0; i < count; i++) {
        double radius = rounds[i].radius, share = rounds[i].share, away, aside;
        struct round *kept = &rounds[round_count];

        LOCAL(middle, rounds[i].middle);
        away = LENGTH(middle);
        if (away <= radius + ON_M) {
            inside = 1;
            continue;
        }
        aside = cosine * __builtin_fabs(middle.y) - sine * middle.x;
        if (aside > radius || middle.x <= -radius || away - radius > ping->range)
            continue;
        kept->middle.x = middle.x;
        kept->middle.y = middle.y;
        kept->radius = radius;
        kept->share = share;
        round_count++;
    }
    return inside;
}

/* Distances to the first shapes along a ray, which are needed twice. */
static double distances[FEW];

static double nearest_on(const struct point *ray)
{
    double nearest = INFINITY, distance;
    int i, n = 0;

    for (i = 0; i < face_count; i++, n++) {
        distance = to_face(&faces[i], ray);
        nearest = distance < nearest ? distance : nearest;
        if (n < FEW)
            distances[n] = distance;
    }
    for (i = 0; i < round_count; i++, n++) {
        distance = to_round(&rounds[i], ray);
        nearest = distance < nearest ? distance : nearest;
        if (n < FEW)
            distances[n] = distance;
    }
    return nearest;
}

/* Find the first echo along a ray, on which a hard object is heard up to a distance. */
static void try_ray(const struct point *ray, double loud, double glancing, int shaped)
{
    double reach = loud, nearest = nearest_on(ray), distance;
    int i, n = 0;

    if (nearest > loud)
        return;
    if (shaped && nearest + BEFORE_M < reach)
        reach = nearest + BEFORE_M;
    for (i = 0; i < face_count; i++, n++) {
        distance = n < FEW ? distances[n] : to_face(&faces[i], ray);
        /* Rounding must not silence a face at exactly the critical angle. */
        if (distance < found && distance <= reach && distance <= loud * faces[i].share
            && distance <= faces[i].away / glancing + ON_M)
            found = distance;
    }
    for (i = 0; i < round_count; i++, n++) {
        distance = n < FEW ? distances[n] : to_round(&rounds[i], ray);
        if (distance < found && distance <= reach && distance <= loud * rounds[i].share)
            found = distance;
    }
}

/* Try rays from one side of the beam to the other, in pairs. */
static void try_rays(int rays, double glancing, int shaped)
{
    struct point ray;
    int i;

    for (i = 0; i <= (rays - 1) / 2; i++) {
        double angle = ping->half * (1 - 2.0 * i / (rays - 1)), loud = range_at(angle);

        ray.x = cos(angle);
        ray.y = sin(angle);
        try_ray(&ray, loud, glancing, shaped);
        if (angle != 0) {
            ray.y = -ray.y;
            try_ray(&ray, loud, glancing, shaped);
        }
    }
}

static int is_hidden(const struct point *place, double away)
{
    struct point ray;
    double inverse = 1 / (away > ON_M ? away : ON_M);
    int i;

    ray.x = place->x * inverse;
    ray.y = place->y * inverse;
    for (i = 0; i < face_count; i++)
        if (to_face(&faces[i], &ray) < away - BEFORE_M)
            return 1;
    for (i = 0; i < round_count; i++)
        if (to_round(&rounds[i], &ray) < away - BEFORE_M)
            return 1;
    return 0;
}

/* Hear a target that is in the beam and, if shapes matter, that nothing hides. */
static void hear(const struct point *place, double reported, double share, int shaped)
{
    double away, angle;

    if (!(reported < found) || __builtin_fabs(place->y) > tangent * place->x)
        return;
    away = LENGTH(*place);
    angle = ping->falloff == 0 ? 0 : atan2(place->y, place->x);
    if (away <= range_at(angle) * share && !(shaped && is_hidden(place, away)))
        found = reported;
}

static int parallel(const struct point *a, const struct point *b)
{
    return __builtin_fabs(CROSS(*a, *b)) <= STRAIGHT * LENGTH(*a) * LENGTH(*b);
}

/* Whether no other face continues a face at its end. */
static int is_corner(int number, const struct point *end)
{
    struct point apart;
    int i;

    for (i = 0; i < face_count; i++) {
        const struct face *other = &faces[i];
        double length = LENGTH(other->along), over;

        if (i == number)
            continue;
        MINUS(apart, *end, other->start);
        over = DOT(apart, other->along) / length;
        if (__builtin_fabs(CROSS(apart, other->along)) <= SEAM_M * length && over >= -SEAM_M
            && over <= length + SEAM_M && parallel(&faces[number].along, &other->along))
            return 0;
    }
    return 1;
}

/* The feet of perpendiculars, and the nearest points of circles. */
static void try_feet(int shaped)
{
    struct point place;
    int i;

    for (i = 0; i < face_count; i++) {
        const struct face *face = &faces[i];
        double share = -DOT(face->start, face->along) / DOT(face->along, face->along);

        if (share > 0 && share < 1) {
            place.x = face->start.x + share * face->along.x;
            place.y = face->start.y + share * face->along.y;
            hear(&place, LENGTH(place), face->share, shaped);
        }
    }
    for (i = 0; i < round_count; i++) {
        double factor = 1 - rounds[i].radius / LENGTH(rounds[i].middle);

        place.x = rounds[i].middle.x * factor;
        place.y = rounds[i].middle.y * factor;
        hear(&place, LENGTH(place), rounds[i].share, shaped);
    }
}

static void try_end(int number, const struct point *end, int shaped)
{
    double away = LENGTH(*end);

    if (away < found && (!shaped || is_corner(number, end)))
        hear(end, away, faces[number].share, shaped);
}

static void try_ends(int shaped)
{
    struct point end;
    int i;

    for (i = 0; i < face_count; i++) {
        try_end(i, &faces[i].start, shaped);
        end.x = faces[i].start.x + faces[i].along.x;
        end.y = faces[i].start.y + faces[i].along.y;
        try_end(i, &end, shaped);
    }
}

static double to_nearest(const struct face *face)
{
    double share = -DOT(face->start, face->along) / DOT(face->along, face->along);
    struct point place;

    share = share < 0 ? 0 : share > 1 ? 1 : share;
    place.x = face->start.x + share * face->along.x;
    place.y = face->start.y + share * face->along.y;
    return LENGTH(place);
}

/* The point where two faces meet. Sound is reflected by both, so the softer one decides. */
static void try_corner(const struct face *one, const struct face *other)
{
    struct point apart, place;
    double across = CROSS(one->along, other->along), share, others;

    MINUS(apart, other->start, one->start);
    share = CROSS(apart, other->along) / across;
    others = CROSS(apart, one->along) / across;
    if (!(share >= 0 && share <= 1 && others >= 0 && others <= 1)
        || parallel(&one->along, &other->along))
        return;
    place.x = one->start.x + share * one->along.x;
    place.y = one->start.y + share * one->along.y;
    hear(&place, LENGTH(place), one->share < other->share ? one->share : other->share, 1);
}

static void try_corners(void)
{
    int i, j;

    for (i = 0; i < face_count; i++) {
        if (to_nearest(&faces[i]) > found + BEFORE_M)
            continue;
        for (j = i + 1; j < face_count; j++)
            if (to_nearest(&faces[j]) <= found + BEFORE_M)
                try_corner(&faces[i], &faces[j]);
    }
}

static void try_crosstalk(const struct crosstalk_ping *crosstalk, int count)
{
    int i;

    for (i = 0; i < count; i++)
        hear(&crosstalk[i].place, crosstalk[i].reported, crosstalk[i].share, 1);
}

/* How a ping is computed depends on itself and on whether there are soft objects, never on the
   other pings of the call. */
void __crs_echoes(int count, int absorbing, const double *pings, double *face_table,
                  double *round_table, const double *crosstalk_table, double *out)
{
    const struct crosstalk_ping *crosstalk = (const struct crosstalk_ping *)crosstalk_table;
    int number, inside;

    ping = (const struct ping *)pings;
    faces = (struct face *)face_table;
    rounds = (struct round *)round_table;
    for (number = 0; number < count; number++, ping++) {
        double glancing = cos(ping->critical);
        /* whether it matters what is hidden or is no corner */
        int shaped = absorbing || ping->falloff > 0 || ping->critical < ANY_ANGLE || ping->crosstalk > 0;

        found = INFINITY;
        cosine = cos(ping->half);
        sine = sin(ping->half);
        tangent = tan(ping->half);
        glancing = glancing > 1e-12 ? glancing : 1e-12;
        inside = keep_faces((int)ping->faces);
        inside |= keep_rounds((int)ping->rounds);
        if (!inside) {
            try_rays(ping->falloff > 0 ? LOBE_RAYS : SIDES, glancing, shaped);
            try_feet(shaped);
            try_ends(shaped);
            if (shaped) {
                try_corners();
                try_crosstalk(crosstalk, (int)ping->crosstalk);
            }
        }
        out[number] = inside ? 0 : found;
        faces += (int)ping->faces;
        rounds += (int)ping->rounds;
        crosstalk += (int)ping->crosstalk;
    }
}
