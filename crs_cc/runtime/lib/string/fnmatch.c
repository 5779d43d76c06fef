/* Patterns of file names (POSIX fnmatch): *, ? and [sets]. */
#include <ctype.h>
#include <fnmatch.h>
#include <string.h>

#include <crs/folder.h>

static int folded(int c, int flags)
{
    return flags & FNM_CASEFOLD ? tolower(c) : c;
}

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
}

static int is_of_class(const char *name, int size, int c)
{
    static const struct { const char *name; int (*test)(int); } classes[] = {
        {"alnum", isalnum}, {"alpha", isalpha}, {"blank", is_blank}, {"cntrl", iscntrl},
        {"digit", isdigit}, {"graph", isgraph}, {"lower", islower}, {"print", isprint},
        {"punct", ispunct}, {"space", isspace}, {"upper", isupper}, {"xdigit", isxdigit},
    };
    unsigned int i;

    for (i = 0; i < sizeof classes / sizeof *classes; i++)
        if (strncmp(classes[i].name, name, size) == 0 && classes[i].name[size] == 0)
            return classes[i].test(c) != 0;
    return 0;
}

/* Compares a character with the set after a [; returns the place after its ], or a null pointer if
   there is none. */
static const char *match_set(const char *at, int c, int flags, int *matches)
{
    int negated = *at == '!' || *at == '^', found = 0, first = 1;

    at += negated;
    for (; *at != ']' || first; first = 0) {
        int from, to;
        if (*at == 0)
            return NULL;
        if (*at == '[' && at[1] == ':') {
            const char *end = strstr(at + 2, ":]");
            if (end != NULL) {
                found |= is_of_class(at + 2, end - at - 2, c);
                at = end + 2;
                continue;
            }
        }
        if (*at == '\\' && !(flags & FNM_NOESCAPE) && at[1] != 0)
            at++;
        from = to = folded((unsigned char)*at++, flags);
        if (*at == '-' && at[1] != ']' && at[1] != 0) {
            at++;
            if (*at == '\\' && !(flags & FNM_NOESCAPE) && at[1] != 0)
                at++;
            to = folded((unsigned char)*at++, flags);
        }
        found |= from <= folded(c, flags) && folded(c, flags) <= to;
    }
    *matches = found != negated;
    return at + 1;
}

static int is_leading(const char *text, const char *start, int flags)
{
    return *text == '.' && flags & FNM_PERIOD &&
           (text == start || (flags & FNM_PATHNAME && text[-1] == '/'));
}

/* Matches one character of the text; returns the rest of the pattern, null if it does not match. */
static const char *match_one(const char *pattern, const char *text, const char *start, int flags)
{
    int c = (unsigned char)*text, matches;
    const char *behind;

    if (c == 0)
        return NULL;
    if (*pattern == '?' || *pattern == '[') {
        if ((c == '/' && flags & FNM_PATHNAME) || is_leading(text, start, flags))
            return NULL;
        if (*pattern == '?')
            return pattern + 1;
        behind = match_set(pattern + 1, c, flags, &matches);
        if (behind != NULL)
            return matches ? behind : NULL;
    }
    if (*pattern == '\\' && !(flags & FNM_NOESCAPE) && pattern[1] != 0)
        pattern++;
    return folded((unsigned char)*pattern, flags) == folded(c, flags) ? pattern + 1 : NULL;
}

/* A star that has matched is tried again with one more character, the last star only: what the ones
   before it matched can stay, but with FNM_PATHNAME no star goes over a slash. */
int __crs_match_name(const char *pattern, const char *text, int flags)
{
    const char *start = text, *star = NULL, *again = NULL, *next;

    for (;;) {
        if (*pattern == '*') {
            if (is_leading(text, start, flags))
                return FNM_NOMATCH;
            star = ++pattern;
            again = text;
            continue;
        }
        if (*pattern == 0 && (*text == 0 || (*text == '/' && flags & FNM_LEADING_DIR)))
            return 0;
        next = *pattern == 0 ? NULL : match_one(pattern, text, start, flags);
        if (next != NULL) {
            pattern = next;
            if (*text == '/' && flags & FNM_PATHNAME)
                star = NULL;
            text++;
            continue;
        }
        if (star == NULL || *again == 0 || (*again == '/' && flags & FNM_PATHNAME))
            return FNM_NOMATCH;
        pattern = star;
        text = ++again;
    }
}

int fnmatch(const char *pattern, const char *text, int flags)
{
    return __crs_match_name(pattern, text, flags);
}
