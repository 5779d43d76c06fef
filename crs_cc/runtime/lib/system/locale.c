/* Localisation (C17 7.11). */
#include <limits.h>
#include <locale.h>
#include <string.h>

/* The user's own locale, "", is "C", too. */
char *setlocale(int category, const char *name)
{
    if (category < LC_CTYPE || category > LC_ALL)
        return NULL;
    if (name == NULL || *name == 0 || strcmp(name, "C") == 0 || strcmp(name, "POSIX") == 0)
        return "C";
    return NULL;
}

struct lconv *localeconv(void)
{
    static char nothing[1], point[2] = ".";
    static struct lconv conventions = {
        point, nothing, nothing, nothing, nothing, nothing, nothing, nothing, nothing, nothing,
        CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX,
        CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX, CHAR_MAX,
    };

    return &conventions;
}
