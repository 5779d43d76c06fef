/* Finds words of tables that have changed, and enters those that have changed elsewhere.

   A row has a mask, with a bit for each of its words that says whether it has changed. The masks of
   some rows are followed by the words that have. */
#include <crs_request.h>

#define ROWS 1024               /* at once */
#define WORDS 56                /* of a row */
#define SOME 8                  /* words of a row that are compared at once */

typedef unsigned long long word;

enum { ADDRESSES, PACK, ENTER };
enum { DONE, ENDS_EARLY, NO_SUCH_WORD, FORBIDDEN };

/* What may be changed in a row: bits of a word that must stay, its greatest value, and bits of its
   value that must not become less; and the bits that are looked for. */
static struct rules {
    word fixed[WORDS], most[WORDS], rising[WORDS], wanted[WORDS];
} rules;

static word known[ROWS][WORDS], now[ROWS][WORDS];
static word content[ROWS + ROWS * WORDS];       /* that is entered */
static word masks[ROWS], words[ROWS * WORDS];   /* that are packed */
static int ends[ROWS];                          /* of the words of each row */

/* Return whether some words differ. */
static int differ(const word *a, const word *b)
{
    return ((a[0] ^ b[0]) | (a[1] ^ b[1]) | (a[2] ^ b[2]) | (a[3] ^ b[3])
            | (a[4] ^ b[4]) | (a[5] ^ b[5]) | (a[6] ^ b[6]) | (a[7] ^ b[7])) != 0;
}

/* Find how rows differ from what is known. */
static void pack(int rows)
{
    word *out = words;
    int row, i, j;

    for (row = 0; row < rows; row++) {
        const word *before = known[row], *after = now[row];
        word mask = 0;

        for (i = 0; i < WORDS; i += SOME) {
            if (!differ(after + i, before + i))
                continue;
            for (j = i; j < i + SOME; j++)
                if (after[j] != before[j]) {
                    mask |= 1ULL << j;
                    *out++ = after[j];
                }
        }
        masks[row] = mask;
        ends[row] = out - words;
    }
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

/* Enter the words that a mask announces, if they are allowed, and look for bits in them. Return
   whether they are. */
static int enter_row(word *row, word mask, const word *values, int checks, int *found)
{
    for (; mask; mask &= mask - 1) {
        int at = __builtin_ctzll(mask);
        word value = *values++, before = row[at];

        if (checks) {
            if ((before ^ value) & rules.fixed[at] || value > rules.most[at]
                || value < (before & rules.rising[at]))
                return 0;
            *found |= (value & rules.wanted[at]) != 0;
        }
        row[at] = value;
    }
    return 1;
}

/* Enter what a content of some words says; more than that may follow. */
static int enter(int rows, int size, int checks, int *used, int *found)
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
    for (row = 0; row < rows; row++) {
        if (!enter_row(known[row], content[row], values, checks, found))
            return FORBIDDEN;
        values += __builtin_popcountll(content[row]);
    }
    return DONE;
}

int __crs_start(void)
{
    static struct __crs_message message;
    static int n[7];

    message.i[0] = (int)n;
    for (;;) {
        __crs_request(1, &message);
        if (n[0] == PACK)
            pack(n[1]);
        else if (n[0] == ENTER)
            n[0] = enter(n[1], n[2], n[3], &n[3], &n[4]);
        else {
            n[0] = (int)&rules;
            n[1] = (int)known;
            n[2] = (int)now;
            n[3] = (int)content;
            n[4] = (int)masks;
            n[5] = (int)words;
            n[6] = (int)ends;
        }
    }
}
