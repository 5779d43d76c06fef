/* Finds words of tables that have changed, and enters those that have changed elsewhere.

   A row has a mask, with a bit for each of its words that says whether it has changed. The masks of
   some rows are followed by the words that have. */
#include <crs_request.h>
#include <string.h>

#define ROWS 1024               /* at once */
#define WORDS 56                /* of a row */
#define SOME 8                  /* words of a row that are compared at once */

typedef unsigned long long word;

enum { ADDRESSES, PACK, CHECK, ENTER, ENTER_ALL, TURN };
enum { DONE, ENDS_EARLY, NO_SUCH_WORD, FORBIDDEN, TOO_LONG };
enum { RUN, PACKED, REFUSED };  /* verdicts */

/* What may be changed in a row: bits of a word that must stay, its greatest value, and bits of its
   value that must not become less; and the bits that are looked for. */
static struct rules {
    word fixed[WORDS], most[WORDS], rising[WORDS], wanted[WORDS];
} rules;

static word known[ROWS][WORDS], now[ROWS][WORDS];
static word content[ROWS + ROWS * WORDS];       /* that is entered */
static word packed[ROWS + ROWS * WORDS + 1];

/* What a fleet is told whose programs take turns with this, see `runtime/partner.py`. */
static struct turn {
    int verdict, ran;           /* rounds, -1 before any */
    double end;
} turn;

/* Return whether some words differ. */
static int differ(const word *a, const word *b)
{
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3])
            | (a[4] ^ b[4]) | (a[5] ^ b[5]) | (a[6] ^ b[6]) | (a[7] ^ b[7])) != 0;
}

/* Pack what differs in some rows from what is known, which becomes known. Return the number of
   words of that. */
static int pack(int rows)
{
    word *out = packed + rows;
    int row, i, j;

    for (row = 0; row < rows; row++) {
        const word *after = now[row];
        word *before = known[row];
        word mask = 0;

        for (i = 0; i < WORDS; i += SOME) {
            if (!differ(after + i, before + i))
                continue;
            for (j = i; j < i + SOME; j++) {    /* no branch: which words differ is hard to guess */
                word differs = after[j] != before[j];

                mask |= differs << j;
                *out = before[j] = after[j];
                out += differs;
            }
        }
        packed[row] = mask;
    }
    return out - packed;
}

/* Return the number of words that masks announce, -1 if one is not in its row. */
static int announced(int rows)
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
static int is_allowed(const word *row, word mask, const word *values, int *found)
{
    for (; mask; mask &= mask - 1) {
        int at = __builtin_ctzll(mask);
        word value = *values++, before = row[at];

        if ((before ^ value) & rules.fixed[at] || value > rules.most[at]
            || value < (before & rules.rising[at]))
            return 0;
        *found |= (value & rules.wanted[at]) != 0;
    }
    return 1;
}

/* Check what a content of some words says about rows; more than that may follow. */
static int check(int rows, int size, int has_rules, int *used, int *found)
{
    const word *values = content + rows;
    int count, row;

    if (size < rows)
        return ENDS_EARLY;
    count = announced(rows);
    if (count < 0)
        return NO_SUCH_WORD;
    if (size - rows < count)
        return ENDS_EARLY;
    *used = rows + count;
    *found = 0;
    for (row = 0; has_rules && row < rows; row++) {
        if (!is_allowed(known[row], content[row], values, found))
            return FORBIDDEN;
        values += __builtin_popcountll(content[row]);
    }
    return DONE;
}

/* Enter what a content says that has been checked. */
static void enter(int rows)
{
    const word *values = content + rows;
    int row;

    for (row = 0; row < rows; row++) {
        word mask = content[row];

        for (; mask; mask &= mask - 1)
            known[row][__builtin_ctzll(mask)] = *values++;
    }
}

/* Enter all that a content says, if it is valid and allowed. */
static int enter_all(int rows, int size, int has_rules, int *found)
{
    int used, error = check(rows, size, has_rules, &used, found);

    if (!error && used < size)
        error = TOO_LONG;
    if (!error)
        enter(rows);
    return error;
}

/* Have programs run with what a content says of their rows, and pack what they have changed. Return
   an error, if there is any. */
static int take_turn(int rows, int size, int *packed_words)
{
    int error = DONE, found;

    if (turn.ran >= 0) {
        *packed_words = pack(rows);
        turn.verdict = PACKED;
        return DONE;
    }
    if (size)
        error = enter_all(rows, size, 0, &found);
    if (!error)
        memcpy(now, known, rows * sizeof *now);
    turn.verdict = error ? REFUSED : RUN;
    return error;
}

int __crs_start(void)
{
    static struct __crs_message message;
    static int n[8];            /* what to do, arguments and results; results of a turn at the end */

    message.i[0] = (int)n;
    for (;;) {
        __crs_request(1, &message);
        if (n[0] == PACK)
            n[1] = pack(n[1]);
        else if (n[0] == CHECK)
            n[0] = check(n[1], n[2], n[3], &n[3], &n[4]);
        else if (n[0] == ENTER)
            enter(n[1]);
        else if (n[0] == ENTER_ALL)
            n[0] = enter_all(n[1], n[2], n[3], &n[4]);
        else if (n[0] == TURN)
            n[6] = take_turn(n[1], n[2], &n[7]);
        else {
            n[0] = (int)&rules;
            n[1] = (int)known;
            n[2] = (int)now;
            n[3] = (int)content;
            n[4] = (int)packed;
            n[5] = (int)&turn;
        }
    }
}
