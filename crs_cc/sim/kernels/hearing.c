/* Which robots messages are for, among those that lie in the arena sorted by the cells of a grid, see
   `hearing.py`. */
#include <math.h>

#include "grid.h"

struct message {
    double x, y, range;                 /* where it is sent, and how far it is heard [m] */
    double sender, to, groups;          /* the robot that it is for, or -1; bits, 0 for everybody */
};

struct place {
    double x, y;
};

/* What is known of a robot. */
struct hearer {
    int is_full;                        /* whether it takes no message to several robots */
    unsigned groups;
};

/* A message and a robot that it is for. */
struct pair {
    int message, hearer;
    double distance;
};

static double distance_of(const struct message *message, const struct place *place)
{
    double x = place->x - message->x, y = place->y - message->y;

    return __builtin_sqrt(x * x + y * y);
}

/* Mark the robots that hear a message to several, by a bit each; return whether any in range is full. */
static int mark(const struct field *field, const struct message *message, const struct place *places,
                const struct hearer *hearers, unsigned long long *marks)
{
    unsigned groups = (unsigned)message->groups;
    int range[4], row, k, last, is_missed = 0;
    struct box box;

    box.left = box.right = message->x;
    box.low = box.high = message->y;
    stretch(&box, message->x, message->y, message->range * (1 + SLACK) + ON);
    meet(field, &box, range);
    for (row = range[2]; row <= range[3]; row++) {
        last = view.first[row * view.columns + range[1] + 1];
        for (k = view.first[row * view.columns + range[0]]; k < last; k++) {
            int hearer = (int)view.circles[view.lists[k]].object;

            if (!(distance_of(message, &places[hearer]) <= message->range) || hearer == (int)message->sender)
                continue;
            if (groups && !(groups & hearers[hearer].groups))
                continue;
            if (hearers[hearer].is_full)
                is_missed = 1;
            else
                marks[hearer >> 6] |= 1ull << (hearer & 63);
        }
    }
    return is_missed;
}

/* Note a pair of each robot that is marked, in rising order, and remove the marks; return their number. */
static int collect(const struct message *message, int number, int robots, const struct place *places,
                   unsigned long long *marks, struct pair *pairs)
{
    int word, found = 0;

    for (word = 0; word < (robots + 63) / 64; word++) {
        unsigned long long bits = marks[word];

        for (; bits; bits &= bits - 1) {
            int hearer = 64 * word + __builtin_ctzll(bits);

            pairs[found].message = number;
            pairs[found].hearer = hearer;
            pairs[found++].distance = distance_of(message, &places[hearer]);
        }
        marks[word] = 0;
    }
    return found;
}

int __crs_hear(int first, int count, int robots, int room, const double *told, const double *content,
               const double *said, double *work, int *missed)
{
    const struct field *field = (const struct field *)content;
    const struct message *messages = (const struct message *)said;
    const struct place *places = (const struct place *)told;
    const struct hearer *hearers = (const struct hearer *)(told + 2 * robots);
    unsigned long long *marks = (unsigned long long *)work;
    struct pair *pairs = (struct pair *)(marks + (robots + 63) / 64);
    int i, found = 0;

    open_field(field);
    for (i = 0; i < (robots + 63) / 64; i++)
        marks[i] = 0;
    for (i = first; i < count && found + robots <= room; i++) {
        const struct message *message = &messages[i];

        missed[i] = 0;
        if (message->to >= 0) {
            pairs[found].message = i;
            pairs[found].hearer = (int)message->to;
            pairs[found].distance = distance_of(message, &places[(int)message->to]);
            found++;
        } else {
            missed[i] = mark(field, message, places, hearers, marks);
            found += collect(message, i, robots, places, marks, pairs + found);
        }
    }
    missed[count] = found;
    return i;
}
