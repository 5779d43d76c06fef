/* Character classes of the "C" locale, ASCII (C17 7.4). */
#include <ctype.h>

/* One comparison instead of two: below `first` the difference wraps round to a large number. */
#define BETWEEN(c, first, last) ((unsigned)(c) - (first) <= (unsigned)(last) - (first))

int isdigit(int c)
{
    return BETWEEN(c, '0', '9');
}

int islower(int c)
{
    return BETWEEN(c, 'a', 'z');
}

int isupper(int c)
{
    return BETWEEN(c, 'A', 'Z');
}

int isalpha(int c)
{
    return BETWEEN(c | 32, 'a', 'z');
}

int isalnum(int c)
{
    return BETWEEN(c | 32, 'a', 'z') || BETWEEN(c, '0', '9');
}

int isxdigit(int c)
{
    return BETWEEN(c, '0', '9') || BETWEEN(c | 32, 'a', 'f');
}

int isblank(int c)
{
    return c == ' ' || c == '\t';
}

int isspace(int c)
{
    return c == ' ' || BETWEEN(c, '\t', '\r');
}

int iscntrl(int c)
{
    return BETWEEN(c, 0, 31) || c == 127;
}

int isprint(int c)
{
    return BETWEEN(c, ' ', '~');
}

int isgraph(int c)
{
    return BETWEEN(c, '!', '~');
}

int ispunct(int c)
{
    return isgraph(c) && !isalnum(c);
}

int tolower(int c)
{
    return isupper(c) ? c + ('a' - 'A') : c;
}

int toupper(int c)
{
    return islower(c) ? c - ('a' - 'A') : c;
}

int isascii(int c)
{
    return BETWEEN(c, 0, 127);
}

int toascii(int c)
{
    return c & 127;
}
