/* Finds words of tables that have changed, and enters those that have changed elsewhere.

   A row has a mask, with a bit for each of its words that says whether it has changed. The masks of
   some rows are followed by the words that have. Which rows these are, and in which order, says a
   part of the list of members. */
#include <crs_request.h>
#include <math.h>
#include <string.h>

#define ROWS 10240              /* at once */
#define WORDS 56                /* of a row */
#define FRONT 5                 /* words in front of changes, for the rest of a message */
#define MOST_ROUNDS (1 << 24)   /* that a host may say it has run */

typedef unsigned long long word;

enum { ADDRESSES, PACK, CHECK, ENTER, ENTER_ALL, TURN, GRANT, TAKE };
enum { DONE, ENDS_EARLY, NO_SUCH_WORD, FORBIDDEN, TOO_LONG, OTHER_GRANT };
enum { RUN, PACKED, REFUSED };  /* verdicts */

/* Of a row's words, as in `requests/door.py`: the half that has a field. */
#define STATUS(row) ((int)((row)[0] >> 32))
#define CODE(row) ((int)(row)[1])
#define ASKS(row) ((int)((row)[53] >> 32))
#define IS_ALIVE(row) ((int)(row)[53] & 1)
#define CLOCK(row) (*(const double *)((row) + 48))
#define DUE(row) (*(const double *)((row) + 49))

/* What may be changed in a row: bits of a word that must stay, its greatest value, and bits of its
   value that must not become less; and the bits that are looked for. */
static struct rules {
    word fixed[WORDS], most[WORDS], rising[WORDS], wanted[WORDS];
} rules[2];                     /* if programs have run, and if not */

/* Close to each other, however few rows there are: what is known, what is now, and what is packed
   or to be entered. */
static word space[ROWS * (3 * WORDS + 1 + FRONT)];
static word (*known)[WORDS], (*now)[WORDS], *traffic;
static int members[ROWS];       /* rows */

/* What a message says in front of changes, as in `net/frames.py`: a grant its number, the end of the
   cycle [s] and whether the answer is wanted, which says the number and how many rounds were run. */
struct grant {
    word number;
    double end;
    int is_wanted;
} __attribute__((packed));
struct ran {
    word number;
    int rounds;
} __attribute__((packed));

/* Hosts as the environment sees them; each has the part of `traffic` that its members may take, with
   room in front of it. */
static struct hosts {
    int first[ROWS], count[ROWS];       /* members */
    int words[ROWS];            /* packed, or to be entered; -1 for none */
    int error[ROWS];            /* in what it says */
    int granted[ROWS];          /* those that are granted a round */
    int round[ROWS];            /* of the cycle */
    word number[ROWS];          /* of the last grant */
    signed char is_ahead[ROWS], asks[ROWS];
} hosts;

/* What a fleet is told whose programs take turns with this, see `runtime/partner.py`. */
static struct turn {
    int verdict, ran;           /* rounds, -1 before any */
    double end;
} turn;

/* Return where changes of a host are. */
static word *changes(int host)
{
    return traffic + hosts.first[host] * (1 + WORDS) + host * FRONT;
}

/* The mask of those of 8 words that differ. There is no branch: which they are is hard to guess. */
#define DIFFERS(a, b, i) ((a)[i] != (b)[i])
#define DIFFERING(a, b, i) \
    ((word)(DIFFERS(a, b, i) | DIFFERS(a, b, (i) + 1) << 1 | DIFFERS(a, b, (i) + 2) << 2 \
            | DIFFERS(a, b, (i) + 3) << 3 | DIFFERS(a, b, (i) + 4) << 4 \
            | DIFFERS(a, b, (i) + 5) << 5 | DIFFERS(a, b, (i) + 6) << 6 \
            | DIFFERS(a, b, (i) + 7) << 7) << (i))

/* Pack what differs in some members from what is known, which becomes known. Return the number of
   words of that, 0 if nothing does: masks alone say nothing. */
static int pack(word *packed, const int *member, int rows)
{
    word *out = packed + rows;
    int row;

    for (row = 0; row < rows; row++) {
        const word *after = now[member[row]];
        word *before = known[member[row]];
        word rest, mask = DIFFERING(after, before, 0) | DIFFERING(after, before, 8)
            | DIFFERING(after, before, 16) | DIFFERING(after, before, 24)
            | DIFFERING(after, before, 32) | DIFFERING(after, before, 40)
            | DIFFERING(after, before, 48);

        for (rest = mask; rest; rest &= rest - 1) {
            int at = __builtin_ctzll(rest);

            *out++ = before[at] = after[at];
        }
        packed[row] = mask;
    }
    return out == packed + rows ? 0 : out - packed;
}

/* Return the number of words that masks announce, -1 if one is not in its row. */
static int announced(const word *content, int rows)
{
    int found = 0, i;

    for (i = 0; i < rows; i++) {
        if (content[i] >> WORDS)
            return -1;
        found += __builtin_popcountll(content[i]);
    }
    return found;
}

/* Return whether the words that a mask announces are allowed in a row, and look for bits in them. */
static int is_allowed(const struct rules *rules, const word *row, word mask, const word *values,
                      int *found)
{
    for (; mask; mask &= mask - 1) {
        int at = __builtin_ctzll(mask);
        word value = *values++, before = row[at];

        if ((before ^ value) & rules->fixed[at] || value > rules->most[at]
            || value < (before & rules->rising[at]))
            return 0;
        *found |= (value & rules->wanted[at]) != 0;
    }
    return 1;
}

/* Check what a content of some words says about members; more than that may follow. */
static int check(const word *content, const int *member, int rows, int size,
                 const struct rules *rules, int *used, int *found)
{
    const word *values = content + rows;
    int count, row;

    if (size < rows)
        return ENDS_EARLY;
    count = announced(content, rows);
    if (count < 0)
        return NO_SUCH_WORD;
    if (size - rows < count)
        return ENDS_EARLY;
    *used = rows + count;
    *found = 0;
    for (row = 0; rules && row < rows; row++) {
        if (!is_allowed(rules, known[member[row]], content[row], values, found))
            return FORBIDDEN;
        values += __builtin_popcountll(content[row]);
    }
    return DONE;
}

/* Enter what a content says that has been checked. */
static void enter(const word *content, const int *member, int rows)
{
    const word *values = content + rows;
    int row;

    for (row = 0; row < rows; row++) {
        word *into = known[member[row]], mask = content[row];

        for (; mask; mask &= mask - 1)
            into[__builtin_ctzll(mask)] = *values++;
    }
}

/* Enter all that a content says, if it is valid and allowed. */
static int enter_all(const word *content, const int *member, int rows, int size,
                     const struct rules *rules, int *found)
{
    int used, error = check(content, member, rows, size, rules, &used, found);

    if (!error && used < size)
        error = TOO_LONG;
    if (!error)
        enter(content, member, rows);
    return error;
}

/* Show what is known of members. */
static void show(const int *member, int rows)
{
    int row;

    for (row = 0; row < rows; row++)
        memcpy(now[member[row]], known[member[row]], sizeof *now);
}

/* Return whether any member has to run until a time. */
static int any_runs(const int *member, int rows, double end)
{
    int row;

    for (row = 0; row < rows; row++) {
        const word *one = now[member[row]];

        if (IS_ALIVE(one) && CLOCK(one) < end && DUE(one) == INFINITY)
            return 1;
    }
    return 0;
}

/* Pack what has changed for all hosts that have something to run until a time and whose requests
   are answered, and list these. Return how many they are. */
static int grant(int count, int is_new_cycle, double end)
{
    int granted = 0, i;

    for (i = 0; i < count; i++) {
        const int *member = members + hosts.first[i];
        struct grant *front = (struct grant *)changes(i) - 1;

        hosts.words[i] = -1;
        if (is_new_cycle)
            hosts.round[i] = 0;
        if (hosts.is_ahead[i] || !any_runs(member, hosts.count[i], end))
            continue;
        hosts.words[i] = pack(changes(i), member, hosts.count[i]);
        front->number = ++hosts.number[i];
        front->end = end;
        front->is_wanted = 1;
        hosts.granted[granted++] = i;
    }
    return granted;
}

/* Enter what a host says, if it is valid and allowed. */
static int take_one(int host, int words)
{
    const struct ran *front = (const struct ran *)changes(host) - 1;
    int rounds = front->rounds, found = 0, error = DONE;

    if (front->number != hosts.number[host] || rounds < 0 || rounds > MOST_ROUNDS)
        return OTHER_GRANT;
    if (words)
        error = enter_all(changes(host), members + hosts.first[host], hosts.count[host], words,
                          rules + !rounds, &found);
    if (!error) {
        hosts.is_ahead[host] = 1;
        hosts.asks[host] = found;
        hosts.round[host] += rounds;
    }
    return error;
}

/* Enter what hosts say. Return how many of them say what is not valid or not allowed. */
static int take(int count)
{
    int bad = 0, i;

    for (i = 0; i < count; i++) {
        int words = hosts.words[i];

        hosts.words[i] = -1;
        hosts.error[i] = words < 0 ? DONE : take_one(i, words);
        bad += hosts.error[i] != DONE;
    }
    return bad;
}

/* Show what has been done up to the first round in which a program asks for anything. Return this
   round, or the last one. */
static int reach(int count, int before, int *any)
{
    int first = -1, last = before, i;

    *any = 0;
    for (i = 0; i < count; i++) {
        if (!hosts.is_ahead[i])
            continue;
        if (hosts.asks[i] && (first < 0 || hosts.round[i] < first))
            first = hosts.round[i];
        if (!*any || hosts.round[i] > last)
            last = hosts.round[i];
        *any = 1;
    }
    if (first >= 0)
        last = first;
    for (i = 0; i < count; i++)
        if (hosts.is_ahead[i] && (!hosts.asks[i] || hosts.round[i] == last)) {
            show(members + hosts.first[i], hosts.count[i]);
            hosts.is_ahead[i] = 0;
        }
    return last;
}

/* Return whether any of some rows asks for a code, or has a status. */
static int any_asks(int rows, int code, int status)
{
    int row;

    for (row = 0; row < rows; row++)
        if (ASKS(now[row]) && (CODE(now[row]) == code || STATUS(now[row]) == status))
            return 1;
    return 0;
}

/* Have programs run with what a grant says of their rows, and pack what they have changed behind the
   front of the answer. Return an error, if there is any. */
static int take_turn(int rows, int size, int *packed_words)
{
    static word number;
    const struct grant *asked = (const struct grant *)traffic - 1;
    int error = DONE, found;

    if (turn.ran >= 0) {
        struct ran *answer = (struct ran *)traffic - 1;

        *packed_words = pack(traffic, members, rows);
        answer->number = number;
        answer->rounds = turn.ran;
        turn.ran = -1;
        turn.verdict = PACKED;
        return DONE;
    }
    number = asked->number;
    turn.end = asked->end;
    if (size)
        error = enter_all(traffic, members, rows, size, NULL, &found);
    if (!error)
        memcpy(now, known, rows * sizeof *now);
    turn.verdict = error ? REFUSED : RUN;
    return error;
}

int __crs_start(void)
{
    static struct __crs_message message;
    static int n[8];            /* what to do, arguments and results; a turn keeps its arguments */
    int i;

    message.i[0] = (int)n;
    for (;;) {
        __crs_request(1, &message);
        switch (n[0]) {
        case PACK:
            n[1] = pack(traffic, members, n[1]);
            break;
        case CHECK:
            n[0] = check(traffic, members, n[1], n[2], n[3] ? rules : NULL, &n[3], &n[4]);
            break;
        case ENTER:
            enter(traffic, members, n[1]);
            break;
        case ENTER_ALL:
            n[0] = enter_all(traffic, members, n[1], n[2], n[3] ? rules : NULL, &n[4]);
            break;
        case TURN:
            n[6] = take_turn(n[1], n[2], &n[7]);
            n[5] = turn.verdict == PACKED && any_asks(n[1], n[3], n[4]);
            break;
        case GRANT:
            n[0] = grant(n[1], n[2], turn.end);
            break;
        case TAKE:
            n[0] = take(n[1]);
            if (!n[0])
                n[1] = reach(n[1], n[2], &n[2]);
            break;
        default:                /* ADDRESSES for a number of rows */
            known = (word (*)[WORDS])space;
            now = known + n[1];
            traffic = now[n[1]] + FRONT;
            for (i = 0; i < n[1]; i++)
                members[i] = i;
            turn.ran = -1;
            n[0] = (int)rules;
            n[1] = (int)known;
            n[2] = (int)now;
            n[3] = (int)traffic;
            n[4] = (int)&turn;
            n[5] = (int)members;
            n[6] = (int)&hosts;
        }
    }
}
