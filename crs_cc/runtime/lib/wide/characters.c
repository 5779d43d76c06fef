/* Classes of wide characters (C17 7.30): ASCII's; all others are letters without case. */
#include <ctype.h>
#include <string.h>
#include <wchar.h>
#include <wctype.h>

static int is_blank(int c)
{
    return c == ' ' || c == '\t';
}

static int is_beyond(wint_t c)
{
    return c >= 0xa0 && c <= 0x10ffff;
}

#define CLASS(name, narrow, beyond)                             \
    int name(wint_t c)                                          \
    {                                                           \
        return c < 128 ? narrow(c) : beyond && is_beyond(c);    \
    }

CLASS(iswalnum, isalnum, 1)
CLASS(iswalpha, isalpha, 1)
CLASS(iswblank, is_blank, 0)
CLASS(iswcntrl, iscntrl, 0)
CLASS(iswdigit, isdigit, 0)
CLASS(iswgraph, isgraph, 1)
CLASS(iswlower, islower, 0)
CLASS(iswprint, isprint, 1)
CLASS(iswpunct, ispunct, 0)
CLASS(iswspace, isspace, 0)
CLASS(iswupper, isupper, 0)
CLASS(iswxdigit, isxdigit, 0)

wint_t towlower(wint_t c)
{
    return c < 128 ? (wint_t)tolower(c) : c;
}

wint_t towupper(wint_t c)
{
    return c < 128 ? (wint_t)toupper(c) : c;
}

static const struct {
    const char *name;
    int (*test)(int c);
    int beyond;
} classes[] = {
    {"alnum", isalnum, 1}, {"alpha", isalpha, 1}, {"blank", is_blank, 0}, {"cntrl", iscntrl, 0},
    {"digit", isdigit, 0}, {"graph", isgraph, 1}, {"lower", islower, 0}, {"print", isprint, 1},
    {"punct", ispunct, 0}, {"space", isspace, 0}, {"upper", isupper, 0}, {"xdigit", isxdigit, 0},
};

#define COUNT ((int)(sizeof classes / sizeof *classes))

wctype_t wctype(const char *name)
{
    int i;

    for (i = 0; i < COUNT; i++)
        if (strcmp(name, classes[i].name) == 0)
            return i + 1;
    return 0;
}

int iswctype(wint_t c, wctype_t class)
{
    if (class < 1 || class > COUNT)
        return 0;
    return c < 128 ? classes[class - 1].test(c) : classes[class - 1].beyond && is_beyond(c);
}

wctrans_t wctrans(const char *name)
{
    return strcmp(name, "tolower") == 0 ? 1 : strcmp(name, "toupper") == 0 ? 2 : 0;
}

wint_t towctrans(wint_t c, wctrans_t change)
{
    if (c >= 128 || (change != 1 && change != 2))
        return c;
    return change == 1 ? tolower(c) : toupper(c);
}

wint_t btowc(int c)
{
    return c >= 0 && c < 128 ? (wint_t)c : WEOF;
}

int wctob(wint_t c)
{
    return c < 128 ? (int)c : EOF;
}

/* Columns on a terminal: one for each character, none for the null one. */
int wcwidth(wchar_t c)
{
    if (c == 0)
        return 0;
    return (c >= 32 && c < 127) || is_beyond(c) ? 1 : -1;
}
