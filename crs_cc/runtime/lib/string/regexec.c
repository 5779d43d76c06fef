/* Matching regular expressions (POSIX regexec): all ways to match are tried, each longest part
   first, and the longest whole match at the leftmost place is taken (POSIX 9.1). */
#include <ctype.h>
#include <string.h>

#include "regular.h"

#define GROUPS 32          /* groups of which the places are kept */

/* What is left to match after a node. */
struct rest {
    int node;              /* a node, or -1: a group ends; -2: a repetition goes on */
    int value;             /* the number of the group; how often it was repeated */
    int start;             /* where the group, or the last repetition, began */
    const struct rest *next;
};

struct search {
    const struct __crs_regex *regex;
    const char *text;
    int flags, size, longest;
    regmatch_t places[GROUPS], best[GROUPS];
};

static int match(struct search *search, int index, int at, const struct rest *rest);

/* A whole match ends here; it counts if it is longer than those before. Returns whether it cannot
   be longer. */
static int finish(struct search *search, int at)
{
    if (at > search->longest) {
        search->longest = at;
        memcpy(search->best, search->places, sizeof search->best);
    }
    return at == search->size;
}

static int repeat(struct search *search, int index, int count, int start, int at,
                  const struct rest *rest);

static int go_on(struct search *search, int at, const struct rest *rest)
{
    regmatch_t before;
    int done;

    if (rest == NULL)
        return finish(search, at);
    if (rest->node >= 0)
        return match(search, rest->node, at, rest->next);
    if (rest->node <= -2)
        return repeat(search, -rest->node - 2, rest->value, rest->start, at, rest->next);
    before = search->places[rest->value % GROUPS];
    if (rest->value < GROUPS)
        search->places[rest->value] = (regmatch_t){rest->start, at};
    done = go_on(search, at, rest->next);
    if (!done && rest->value < GROUPS)
        search->places[rest->value] = before;
    return done;
}

/* Goes on after `count` repetitions, of which the last began at `start`: first with one more. */
static int repeat(struct search *search, int index, int count, int start, int at,
                  const struct rest *rest)
{
    const struct node *node = &search->regex->node[index];
    struct rest again = {-index - 2, count + 1, at, rest};

    if (count > 1 && count > node->least && at == start)
        return 0;   /* a further repetition matches something */
    if (count < node->most && match(search, node->left, at, &again))
        return 1;
    return count >= node->least && go_on(search, at, rest);
}

static int is_line_start(const struct search *search, int at)
{
    if (at == 0)
        return !(search->flags & REG_NOTBOL);
    return search->regex->flags & REG_NEWLINE && search->text[at - 1] == '\n';
}

static int is_line_end(const struct search *search, int at)
{
    if (at == search->size)
        return !(search->flags & REG_NOTEOL);
    return search->regex->flags & REG_NEWLINE && search->text[at] == '\n';
}

static int same(const struct search *search, int a, int b)
{
    return a == b || (search->regex->flags & REG_ICASE && tolower(a) == tolower(b));
}

/* Returns how many characters a node without parts matches here, -1 if it does not. */
static int single(const struct search *search, const struct node *node, int at)
{
    int c = (unsigned char)search->text[at], is_end = at == search->size, i, size;
    regmatch_t group;

    switch (node->kind) {
    case EMPTY: return 0;
    case START: return is_line_start(search, at) ? 0 : -1;
    case END: return is_line_end(search, at) ? 0 : -1;
    case ANY: return is_end || (c == '\n' && search->regex->flags & REG_NEWLINE) ? -1 : 1;
    case CHARACTER: return !is_end && same(search, c, node->value) ? 1 : -1;
    case SET: return !is_end && search->regex->set[node->value][c / 8] >> c % 8 & 1 ? 1 : -1;
    default: break;
    }
    group = search->places[node->value % GROUPS];
    size = group.rm_eo - group.rm_so;
    if (group.rm_so < 0 || at + size > search->size)
        return -1;
    for (i = 0; i < size; i++)
        if (!same(search, (unsigned char)search->text[group.rm_so + i],
                  (unsigned char)search->text[at + i]))
            return -1;
    return size;
}

/* Matches a node and then the rest; returns 1 once no longer match is possible. */
static int match(struct search *search, int index, int at, const struct rest *rest)
{
    const struct node *node = &search->regex->node[index];
    struct rest after = {node->right, 0, 0, rest};
    int size;

    switch (node->kind) {
    case SEQUENCE:
        return match(search, node->left, at, &after);
    case CHOICE:
        return match(search, node->left, at, rest) || match(search, node->right, at, rest);
    case GROUP:
        after = (struct rest){-1, node->value, at, rest};
        return match(search, node->left, at, &after);
    case REPEAT:
        return repeat(search, index, 0, -1, at, rest);
    default:
        size = single(search, node, at);
        return size >= 0 && go_on(search, at + size, rest);
    }
}

int regexec(const regex_t *regex, const char *text, size_t count, regmatch_t matches[], int flags)
{
    struct search search;
    int start;
    size_t i;

    search.regex = regex->__program;
    search.text = text;
    search.flags = flags;
    search.size = strlen(text);
    for (start = 0; start <= search.size; start++) {
        search.longest = -1;
        memset(search.places, -1, sizeof search.places);
        match(&search, search.regex->root, start, NULL);
        if (search.longest < 0)
            continue;
        search.best[0] = (regmatch_t){start, search.longest};
        for (i = 0; i < count && !(search.regex->flags & REG_NOSUB); i++)
            matches[i] = i < GROUPS && i <= regex->re_nsub ? search.best[i] : (regmatch_t){-1, -1};
        return 0;
    }
    return REG_NOMATCH;
}
